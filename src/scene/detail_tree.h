// A body at every level of detail, each level as it is written and as FCL is asked about it.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "check/query_body.h"
#include "collision_hulls/scene/fit.h"

namespace collision_hulls {

/// Nodes are those of the hull tree. They are worked out when they are first asked for. Thread safe.
class DetailTree {
 public:
  explicit DetailTree(std::shared_ptr<const FitMesh> mesh);
  explicit DetailTree(const QueryBody& body);  ///< a single node

  int root() const { return static_cast<int>(levels_) - 1; }
  std::vector<int> children(int node) const;  ///< none: a leaf
  int parent(int node) const;                 ///< -1: the root
  std::size_t leaves() const { return (levels_ + 1) / 2; }
  int mostHulls() const { return mesh_ ? mesh_->max_hulls : 0; }
  double protrusion(int node) const { return mesh_ ? mesh_->tree.nodes[static_cast<std::size_t>(node)].protrusion : 0; }
  const QueryBody& body(int node) const;

 private:
  struct Level {
    std::once_flag made;
    std::unique_ptr<const QueryBody> body;
  };

  std::shared_ptr<const FitMesh> mesh_;
  std::size_t levels_ = 1;
  std::unique_ptr<Level[]> made_;
};

/// The hulls of a cut as they are written: grown by the mesh's margin, with no more vertices than allowed; they cover the mesh.
std::vector<ConvexHull> writtenHulls(const FitMesh& mesh, const std::vector<int>& cut, const RunControl& control);

}  // namespace collision_hulls
