#include "scene/detail_tree.h"

#include <cmath>

#include "collision_hulls/decompose/fit_cover.h"
#include "decompose/bounding_box.h"

namespace collision_hulls {
namespace {

constexpr double kRounding = 1e-7;  // of a box's size: its corners as a description has them, in roll, pitch and yaw

}  // namespace

DetailTree::DetailTree(std::shared_ptr<const FitMesh> mesh)
    : mesh_(std::move(mesh)), levels_(mesh_->tree.nodes.size() + (mesh_->box ? 1 : 0)), made_(std::make_unique<Level[]>(levels_)) {}

DetailTree::DetailTree(const QueryBody& body) : made_(std::make_unique<Level[]>(1)) {
  std::call_once(made_[0].made, [&] { made_[0].body = std::make_unique<const QueryBody>(body); });
}

std::vector<int> DetailTree::children(int node) const {
  if (!mesh_) return {};
  if (isBox(node)) return {root()};
  const HullNode& at = mesh_->tree.nodes[static_cast<std::size_t>(node)];
  if (at.left < 0) return {};
  return {at.left, at.right};
}

int DetailTree::parent(int node) const {
  if (node == top()) return -1;
  return node == root() ? top() : mesh_->tree.nodes[static_cast<std::size_t>(node)].parent;
}

ConvexHull DetailTree::written(int node) const {
  if (isBox(node)) return hullOf(*mesh_->box);
  // Of no mesh at all, so that the hull alone is grown and rounded.
  return fitCover({mesh_->tree.nodes[static_cast<std::size_t>(node)].hull}, {}, mesh_->margin, mesh_->max_vertices).hulls.front();
}

const QueryBody& DetailTree::body(int node) const {
  Level& level = made_[static_cast<std::size_t>(node)];
  std::call_once(level.made, [&] { level.body = std::make_unique<const QueryBody>(written(node)); });
  return *level.body;
}

std::vector<ConvexHull> writtenHulls(const FitMesh& mesh, const std::vector<int>& cut, const RunControl& control) {
  return fitCover(mesh.tree.hullsOf(cut), mesh.original, mesh.margin, mesh.max_vertices, control).hulls;
}

ConvexHull hullOf(const GeometryElement& box) {
  std::vector<Eigen::Vector3d> corners = boxShape(box.size).vertices;
  for (Eigen::Vector3d& corner : corners) corner = box.origin * corner;
  return convexHull(corners);
}

std::optional<GeometryElement> boxAbout(const FitMesh& mesh) {
  const ConvexHull root = writtenHulls(mesh, {static_cast<int>(mesh.tree.nodes.size()) - 1}, {}).front();
  const ConvexHull found = orientedBox(root);
  if (found.faces.size() != 6 || found.thickness > 0) return std::nullopt;
  Eigen::Matrix3d axes;
  axes.col(0) = found.faces[0].normal;
  for (const HalfSpace& face : found.faces)
    if (std::abs(face.normal.dot(axes.col(0))) < 0.5) axes.col(1) = face.normal;
  axes.col(2) = axes.col(0).cross(axes.col(1)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  Eigen::AlignedBox3d extent;
  for (const Eigen::Vector3d& v : root.vertices) extent.extend(Eigen::Vector3d(axes.transpose() * v));
  GeometryElement box;
  box.kind = GeometryElement::Kind::kBox;
  box.size = extent.sizes().array() + kRounding * (extent.sizes().norm() + root.vertices.front().norm());
  box.origin = Eigen::Translation3d(axes * extent.center()) * Eigen::Quaterniond(axes).normalized();
  return box;
}

}  // namespace collision_hulls
