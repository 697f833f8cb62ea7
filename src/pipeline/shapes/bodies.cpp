// Distance queries know spheres by their centre and radius, and everything else as polyhedra; so what the polyhedron about a cylinder adds
// to it belongs to its bound.
#include "pipeline/shapes/bodies.h"

#include <algorithm>

namespace collision_hulls {
namespace {

constexpr double kAroundSphere = 0.05;  // of the radius: what the polyhedron about a sphere adds; it is for drawings alone

/// [m] How far the polyhedra reach that stand for the parts of a primitive.
double addedByPolyhedra(const Primitive& primitive) {
  double added = 0;
  for (const Primitive& part : partsOf(primitive)) {
    if (part.kind == PrimitiveKind::kSphere) continue;
    for (const Eigen::Vector3d& v : polyhedronAbout(part).vertices) added = std::max(added, distance(part, v));
  }
  return added;
}

}  // namespace

Body bodyOf(const CertifiedPrimitive& made) {
  return {made.primitive, {}, made.bound + addedByPolyhedra(made.primitive), made.found, made.where, made.nearest};
}

std::vector<Primitive> partsOf(const Primitive& primitive) {
  if (primitive.kind != PrimitiveKind::kCapsule) return {primitive};
  Primitive cylinder = primitive, low, high;
  cylinder.kind = PrimitiveKind::kCylinder;
  low.kind = high.kind = PrimitiveKind::kSphere;
  low.size = high.size = {primitive.size.x(), 0, 0};
  const Eigen::Vector3d half(0, 0, primitive.size.y() / 2);
  low.pose = primitive.pose * Eigen::Translation3d(-half);
  high.pose = primitive.pose * Eigen::Translation3d(half);
  return {cylinder, low, high};
}

ConvexHull polyhedronAbout(const Primitive& primitive) {
  const double share = primitive.kind == PrimitiveKind::kSphere ? kAroundSphere : kAroundRound;
  return hullAround(primitive, share * primitive.size.x());
}

}  // namespace collision_hulls
