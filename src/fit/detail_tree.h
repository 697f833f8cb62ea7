// A body at every level of detail, each level as it is written and as FCL checks it.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "collision_hulls/fit/fit.h"
#include "collision_hulls/query/query_body.h"

namespace collision_hulls {

/// Nodes are those of the hull tree and, for each of them, the primitives that may replace it. They are computed on first use. Thread safe.
///
/// A hull's primitives, the cheapest to check first, are the sphere, the box, and the cylinder if it is smaller than the box; primitives
/// much larger than the hull are dropped. A later primitive is tried where the earlier ones do not do.
class DetailTree {
 public:
  explicit DetailTree(std::shared_ptr<const FitMesh> mesh);
  explicit DetailTree(const QueryBody& body);  ///< a single node

  int root() const { return hulls_ - 1; }
  int cheapest(int hull) const;                       ///< the first of a hull's primitives; itself where there are none
  int hull(int node) const { return node % hulls_; }  ///< the hull that a node is or replaces
  const GeometryElement* primitive(int node) const;   ///< null: the node is a hull
  std::vector<int> children(int node) const;          ///< none: a leaf
  int parent(int hull) const;                         ///< -1: the root
  std::size_t leaves() const { return static_cast<std::size_t>(root()) / 2 + 1; }
  int mostHulls() const { return mesh_ ? mesh_->max_hulls : 0; }
  double protrusion(int node) const { return mesh_ ? mesh_->tree.nodes[static_cast<std::size_t>(hull(node))].protrusion : 0; }
  const QueryBody& body(int node) const;

 private:
  static constexpr std::size_t kKinds = 3;
  using Primitives = std::array<std::optional<GeometryElement>, kKinds>;  // the cheapest first
  template <class T>
  struct Once {
    std::once_flag made;
    std::unique_ptr<const T> value;
  };
  const Primitives& primitives(int hull) const;
  int firstOf(int hull, std::size_t from) const;
  ConvexHull written(int hull) const;

  std::shared_ptr<const FitMesh> mesh_;
  int hulls_ = 1;
  std::unique_ptr<Once<Primitives>[]> primitives_;  // of hulls
  std::unique_ptr<Once<QueryBody>[]> bodies_;       // of hulls, of the first primitive of each, of the second, ...
};

/// The hulls of a cut as they are written: grown by the mesh's margin, with no more vertices than allowed; they cover the mesh.
std::vector<ConvexHull> writtenHulls(const FitMesh& mesh, const std::vector<int>& cut, const RunControl& control);

/// A primitive as FCL checks it.
QueryBody queryBody(const GeometryElement& primitive);

}  // namespace collision_hulls
