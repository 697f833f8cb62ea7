// Node numbers: the hull tree's nodes come first, then the first primitive of each hull, then the second, and so on. Bodies and primitives
// are made on first use, each behind a once_flag, since a fit need not visit all nodes of a tree.
#include "fit/detail_tree.h"

#include "collision_hulls/decompose/round_outward.h"
#include "fit/enclosing.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

// Of the hull's volume. A much larger primitive might not collide more often, but distances to it would be too short.
constexpr double kMostVolume = 1.25;

std::array<std::optional<GeometryElement>, 3> primitivesAbout(const ConvexHull& hull) {
  constexpr std::array<Kind, 3> kinds{Kind::kSphere, Kind::kBox, Kind::kCylinder};  // cheapest first
  std::array<std::optional<GeometryElement>, 3> result;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const GeometryElement primitive = enclosingPrimitive(kinds[k], hull);
    if (volume(primitive) <= kMostVolume * volume(hull)) result[k] = primitive;
  }
  if (result[1] && result[2] && volume(*result[2]) >= volume(*result[1])) result[2].reset();
  return result;
}

}  // namespace

DetailTree::DetailTree(std::shared_ptr<const FitMesh> mesh)
    : mesh_(std::move(mesh)),
      hulls_(static_cast<int>(mesh_->tree.nodes.size())),
      primitives_(std::make_unique<Once<Primitives>[]>(mesh_->tree.nodes.size())),
      bodies_(std::make_unique<Once<QueryBody>[]>(mesh_->tree.nodes.size() * (1 + kKinds))) {}

DetailTree::DetailTree(const QueryBody& body) : bodies_(std::make_unique<Once<QueryBody>[]>(1)) {
  std::call_once(bodies_[0].made, [&] { bodies_[0].value = std::make_unique<const QueryBody>(body); });
}

const DetailTree::Primitives& DetailTree::primitives(int hull) const {
  Once<Primitives>& at = primitives_[static_cast<std::size_t>(hull)];
  std::call_once(at.made, [&] { at.value = std::make_unique<const Primitives>(primitivesAbout(written(hull))); });
  return *at.value;
}

/// The hull's first primitive at or after index `from`; the hull itself if there is none.
int DetailTree::firstOf(int hull, std::size_t from) const {
  const Primitives& all = primitives(hull);
  for (std::size_t k = from; k < kKinds; ++k)
    if (all[k]) return hull + hulls_ * static_cast<int>(1 + k);
  return hull;
}

int DetailTree::cheapest(int hull) const {
  return mesh_ ? firstOf(hull, 0) : hull;
}

const GeometryElement* DetailTree::primitive(int node) const {
  return node < hulls_ ? nullptr : &*primitives(hull(node))[static_cast<std::size_t>(node / hulls_) - 1];
}

std::vector<int> DetailTree::children(int node) const {
  if (!mesh_) return {};
  if (node >= hulls_) return {firstOf(hull(node), static_cast<std::size_t>(node / hulls_))};
  const HullNode& at = mesh_->tree.nodes[static_cast<std::size_t>(node)];
  if (at.left < 0) return {};
  return {at.left, at.right};
}

int DetailTree::parent(int hull) const {
  return mesh_ ? mesh_->tree.nodes[static_cast<std::size_t>(hull)].parent : -1;
}

ConvexHull DetailTree::written(int hull) const {
  // With an empty mesh to cover, roundOutward() only grows the hull, rounds its vertices and caps their number.
  return roundOutward({mesh_->tree.nodes[static_cast<std::size_t>(hull)].hull}, {}, mesh_->margin, mesh_->max_vertices).hulls.front();
}

const QueryBody& DetailTree::body(int node) const {
  Once<QueryBody>& at = bodies_[static_cast<std::size_t>(node)];
  std::call_once(at.made, [&] {
    const GeometryElement* primitive = this->primitive(node);
    at.value = std::make_unique<const QueryBody>(primitive ? queryBody(*primitive) : QueryBody(written(node)));
  });
  return *at.value;
}

std::vector<ConvexHull> writtenHulls(const FitMesh& mesh, const std::vector<int>& cut, const RunControl& control) {
  return roundOutward(mesh.tree.hullsOf(cut), mesh.original, mesh.margin, mesh.max_vertices, control).hulls;
}

QueryBody queryBody(const GeometryElement& primitive) {
  const QueryShape::Kind kind = primitive.kind == Kind::kSphere     ? QueryShape::Kind::kSphere
                                : primitive.kind == Kind::kCylinder ? QueryShape::Kind::kCylinder
                                                                    : QueryShape::Kind::kBox;
  return {{kind, primitive.size}, primitive.origin};
}

}  // namespace collision_hulls
