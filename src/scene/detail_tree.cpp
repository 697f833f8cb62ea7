#include "scene/detail_tree.h"

#include "collision_hulls/decompose/fit_cover.h"

namespace collision_hulls {

DetailTree::DetailTree(std::shared_ptr<const FitMesh> mesh)
    : mesh_(std::move(mesh)), levels_(mesh_->tree.nodes.size()), made_(std::make_unique<Level[]>(levels_)) {}

DetailTree::DetailTree(const QueryBody& body) : made_(std::make_unique<Level[]>(1)) {
  std::call_once(made_[0].made, [&] { made_[0].body = std::make_unique<const QueryBody>(body); });
}

std::vector<int> DetailTree::children(int node) const {
  if (!mesh_) return {};
  const HullNode& at = mesh_->tree.nodes[static_cast<std::size_t>(node)];
  if (at.left < 0) return {};
  return {at.left, at.right};
}

int DetailTree::parent(int node) const {
  return mesh_ ? mesh_->tree.nodes[static_cast<std::size_t>(node)].parent : -1;
}

const QueryBody& DetailTree::body(int node) const {
  Level& level = made_[static_cast<std::size_t>(node)];
  std::call_once(level.made, [&] {
    // Of no mesh at all, so that the hull alone is grown and rounded.
    const std::vector<ConvexHull> hull{mesh_->tree.nodes[static_cast<std::size_t>(node)].hull};
    const FittedHulls written = fitCover(hull, {}, mesh_->margin, mesh_->max_vertices);
    level.body = std::make_unique<const QueryBody>(written.hulls.front());
  });
  return *level.body;
}

std::vector<ConvexHull> writtenHulls(const FitMesh& mesh, const std::vector<int>& cut, const RunControl& control) {
  return fitCover(mesh.tree.hullsOf(cut), mesh.original, mesh.margin, mesh.max_vertices, control).hulls;
}

}  // namespace collision_hulls
