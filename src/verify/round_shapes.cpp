// Both polyhedra have the directions of fit's circumscribed ones. Inscribed, the vertices are drawn back to the surface; the error is how
// far the shape rises above the lowest face, since nothing of the polyhedron is outside.
#include "verify/round_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/enclosing.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

constexpr double kSamePlace = 1e-9;      // of the size: two primitives this close are one
constexpr double kSizeRounding = 1e-12;  // of the size

/// The element at the origin of its own frame.
GeometryElement centred(GeometryElement element) {
  element.origin = Eigen::Isometry3d::Identity();
  return element;
}

/// Whether a face is part of a cylinder's cap, which both polyhedra have in its plane.
bool isCap(const GeometryElement& round, const HalfSpace& face) {
  return round.kind == Kind::kCylinder && std::abs(face.normal.z()) > 0.5;
}

}  // namespace

bool isRound(const GeometryElement& element) {
  return element.kind == Kind::kSphere || element.kind == Kind::kCylinder;
}

double distance(const GeometryElement& primitive, const Eigen::Vector3d& p) {
  return (nearestPoint(primitive, p) - p).norm();
}

Approximation inscribed(const GeometryElement& round) {
  const double radius = round.size.x();
  std::vector<Eigen::Vector3d> points = hullAbout(centred(round)).vertices;
  for (Eigen::Vector3d& p : points) {
    if (round.kind == Kind::kSphere)
      p *= radius / p.norm();
    else
      p.head<2>() *= radius / p.head<2>().norm();
  }
  const ConvexHull hull = convexHull(points);
  double lowest = radius;
  for (const HalfSpace& face : hull.faces)
    if (!isCap(round, face)) lowest = std::min(lowest, face.offset);
  return {transformed(hull, round.origin), radius - lowest};
}

Approximation circumscribed(const GeometryElement& round) {
  const ConvexHull hull = hullAbout(centred(round));
  double furthest = 0;
  for (const Eigen::Vector3d& v : hull.vertices) furthest = std::max(furthest, distance(centred(round), v));
  return {transformed(hull, round.origin), furthest};
}

/// By the support point in the direction of each face.
bool holds(const ConvexHull& hull, const GeometryElement& round) {
  const double radius = round.size.x(), slack = kSizeRounding * (radius + round.origin.translation().cwiseAbs().maxCoeff());
  return std::all_of(hull.faces.begin(), hull.faces.end(), [&](const HalfSpace& face) {
    const Eigen::Vector3d n = round.origin.linear().transpose() * face.normal;
    const double reach = round.kind == Kind::kSphere ? radius : radius * n.head<2>().norm() + round.size.y() / 2 * std::abs(n.z());
    return face.distance(round.origin.translation()) + reach <= slack;
  });
}

/// A point of one goes where the frame of the other puts it: by the shift, the turn times its distance from the origin, and the change of
/// size. A cylinder turns about its own axis, and upside down, without moving a point of its surface.
double apartAtMost(const GeometryElement& a, const GeometryElement& b) {
  if (a.kind != b.kind || a.kind == Kind::kMesh || a.kind == Kind::kNone) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d size = a.size.cwiseMax(b.size), more = (a.size - b.size).cwiseAbs();
  const Eigen::Matrix3d turn = a.origin.linear().transpose() * b.origin.linear() - Eigen::Matrix3d::Identity();
  double moved = (a.origin.translation() - b.origin.translation()).norm();
  if (a.kind == Kind::kSphere) {
    moved += more.x();
  } else if (a.kind == Kind::kCylinder) {
    const Eigen::Vector3d top = turn.col(2), upside_down = top + 2 * Eigen::Vector3d::UnitZ();
    moved += std::min(top.norm(), upside_down.norm()) * std::hypot(size.x(), size.y() / 2) + more.x() + more.y() / 2;
  } else {
    moved += turn.norm() * size.norm() / 2 + more.norm() / 2;
  }
  if (moved <= kSamePlace * size.maxCoeff()) return 0;
  return moved + kSizeRounding * (size.maxCoeff() + a.origin.translation().cwiseAbs().maxCoeff());
}

}  // namespace collision_hulls
