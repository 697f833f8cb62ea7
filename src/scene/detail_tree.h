// A body at every level of detail, each level as it is written and as FCL is asked about it.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include "check/query_body.h"
#include "collision_hulls/scene/fit.h"

namespace collision_hulls {

/// Nodes are those of the hull tree and, where the mesh has one, the box above them. They are worked out when they are first asked for.
/// Thread safe.
class DetailTree {
 public:
  explicit DetailTree(std::shared_ptr<const FitMesh> mesh);
  explicit DetailTree(const QueryBody& body);  ///< a single node

  int top() const { return static_cast<int>(levels_) - 1; }
  int root() const { return hasBox() ? top() - 1 : top(); }  ///< of the hull tree
  bool isBox(int node) const { return hasBox() && node == top(); }
  std::vector<int> children(int node) const;  ///< none: a leaf
  int parent(int node) const;                 ///< -1: the root
  std::size_t leaves() const { return static_cast<std::size_t>(root()) / 2 + 1; }
  int mostHulls() const { return mesh_ ? mesh_->max_hulls : 0; }
  double protrusion(int node) const { return mesh_ ? mesh_->tree.nodes[static_cast<std::size_t>(std::min(node, root()))].protrusion : 0; }
  const QueryBody& body(int node) const;

 private:
  bool hasBox() const { return mesh_ && mesh_->box; }
  ConvexHull written(int node) const;
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

/// A box as a hull, in the frame that its origin is given in.
ConvexHull hullOf(const GeometryElement& box);

}  // namespace collision_hulls
