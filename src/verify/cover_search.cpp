// What lies in the union of the hulls is dropped by exact clipping (measure/cover.h). The rest is searched by branch and bound
// (measure/furthest_point.h).
//
// The union with a mesh that is not convex is one solid, and the search of mesh_protrusion.h knows how to follow its surface.
#include "verify/cover_search.h"

#include <algorithm>
#include <limits>

#include "fit/enclosing.h"
#include "measure/cover.h"
#include "measure/furthest_point.h"
#include "verify/mesh_protrusion.h"
#include "verify/round_shapes.h"

namespace collision_hulls {
namespace {

constexpr int kMostPieces = 400'000;  // that a search halves
constexpr double kRounding = 1e-12;   // of the coordinates' size: distances up to this are rounding errors

double sizeOf(const TriangleMesh& surface) {
  const Eigen::AlignedBox3d box = boundingBox(surface);
  return box.isEmpty() ? 0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

/// Against the convex bodies.
Largest furthestFromConvex(const BodySet& bodies, const TriangleMesh& surface, double gap, const RunControl& control) {
  if (bodies.boxes().empty()) return {std::numeric_limits<double>::infinity(), 0, Eigen::Vector3d::Zero()};
  FurthestPoint<BodySet> furthest(bodies);
  for (const std::vector<Eigen::Vector3d>& left : uncoveredPolygons(surface, bodies.hulls(), control)) furthest.add(left);
  furthest.search(kMostPieces, gap, control);
  if (furthest.found() == 0) furthest.search(kMostPieces, 0, control);  // it may be covered
  if (furthest.bound() <= kRounding * sizeOf(surface)) return {};
  return {furthest.bound(), furthest.found(), furthest.where()};
}

/// Against everything as one solid.
Largest furthestFromWhole(const BodySet& bodies, const TriangleMesh& surface, double gap, const RunControl& control) {
  const Solid& solid = *bodies.whole();
  const Protrusion far = largestOnMesh(surface, solid, gap, control);
  Largest largest;
  largest.where = far.where;
  largest.found = std::max(0.0, far.found - bodies.innerError() - solid.weldDistance());
  largest.bound = far.bound + solid.weldDistance() + solid.sideError() + kRounding * (sizeOf(surface) + solid.surface().extent());
  return largest;
}

TriangleMesh joined(const std::vector<ConvexHull>& hulls, const TriangleMesh& rest) {
  TriangleMesh all = rest;
  for (const ConvexHull& hull : hulls) append(all, surface(hull));
  return all;
}

}  // namespace

BodySet::BodySet(const LinkBodies& bodies, const RunControl& control) : hulls_(bodies.hulls()) {
  for (const GeometryElement& primitive : bodies.primitives) {
    if (isRound(primitive))
      rounds_.push_back(primitive);
    else
      hulls_.push_back(hullAbout(primitive));
  }
  inner_ = hulls_;
  for (const ConvexHull& hull : hulls_) boxes_.push_back(boundingBox(hull));
  for (const GeometryElement& round : rounds_) {
    const Approximation inside = inscribed(round);
    inner_.push_back(inside.hull);
    inner_error_ = std::max(inner_error_, inside.error);
    boxes_.push_back(boundingBox(circumscribed(round).hull));
  }
  const TriangleMesh rest = bodies.rest();
  if (rest.triangles.empty()) return;
  rest_ = std::make_unique<Solid>(repair(rest, {}, control), control);
  whole_ = std::make_unique<Solid>(repair(joined(inner_, rest), {}, control), control);
}

double BodySet::convexDistance(std::size_t body, const Eigen::Vector3d& p) const {
  return body < hulls_.size() ? collision_hulls::distance(hulls_[body], p) : collision_hulls::distance(rounds_[body - hulls_.size()], p);
}

double BodySet::distance(const Eigen::Vector3d& p) const {
  double least = std::numeric_limits<double>::infinity();
  if (rest_) least = rest_->distance(p);
  for (std::size_t b = 0; b < boxes_.size() && least > 0; ++b)
    if (boxes_[b].exteriorDistance(p) < least) least = std::min(least, convexDistance(b, p));
  return least;
}

Largest furthestFrom(const BodySet& bodies, const TriangleMesh& surface, double gap, const RunControl& control) {
  const Largest convex = furthestFromConvex(bodies, surface, gap, control);
  if (!bodies.whole() || convex.bound == 0) return convex;
  Largest all = furthestFromWhole(bodies, surface, gap, control);
  all.bound = std::min(all.bound, convex.bound);
  return all;
}

}  // namespace collision_hulls
