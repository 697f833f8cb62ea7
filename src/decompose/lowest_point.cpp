// Cutting planes: while a plane cuts the optimum off, the optimum moves onto that plane, where the problem has two unknowns.
#include "decompose/lowest_point.h"

#include "decompose/convex_polygon.h"

namespace collision_hulls {

namespace {

// Most planes that a search examines, a guard against cycling due to rounding; and the share of `reach` within which a point is on a plane.
constexpr int kMostCuts = 50;
constexpr double kOnPlane = 1e-13;

/// A square that covers the part of a plane within `reach` of a point.
ConvexPolygon square(const HalfSpace& plane, const Eigen::Vector3d& middle, double reach) {
  const Eigen::Vector3d centre = middle - plane.normal * plane.distance(middle);
  const Eigen::Vector3d a = plane.normal.unitOrthogonal() * (2 * reach), b = plane.normal.cross(a);
  return {centre + a + b, centre - a + b, centre - a - b, centre + a - b};
}

const HalfSpace* mostViolated(const std::vector<HalfSpace>& planes, const Eigen::Vector3d& x, double tolerance) {
  const HalfSpace* worst = nullptr;
  double deepest = -tolerance;
  for (const HalfSpace& plane : planes) {
    const double d = plane.distance(x);
    if (d < deepest) deepest = d, worst = &plane;
  }
  return worst;
}

}  // namespace

std::optional<Eigen::Vector3d> lowestPointBeyond(const std::vector<HalfSpace>& planes, const Eigen::Vector3d& up,
                                                 const Eigen::Vector3d& middle, double reach) {
  std::vector<HalfSpace> cuts;
  for (int k = 0; k < 3; ++k)
    for (double sign : {-1.0, 1.0}) cuts.push_back({sign * Eigen::Vector3d::Unit(k), sign * middle[k] - reach});
  Eigen::Vector3d x = middle - reach * up.cwiseSign();
  ConvexPolygon polygon, scratch;
  for (int cut = 0; cut < kMostCuts; ++cut) {
    const HalfSpace* worst = mostViolated(planes, x, kOnPlane * reach);
    if (!worst) return x;
    polygon = square(*worst, middle, reach);
    for (const HalfSpace& other : cuts)
      clip(
          polygon, [&](const Eigen::Vector3d& p) { return other.distance(p); }, scratch);
    if (polygon.empty()) return std::nullopt;
    cuts.push_back(*worst);
    x = largest(polygon, [&](const Eigen::Vector3d& p) { return -up.dot(p); });
  }
  return std::nullopt;
}

}  // namespace collision_hulls
