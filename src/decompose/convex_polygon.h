// A convex polygon in 3D, clipped by half-planes, as in the two-dimensional step of small linear programs.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace collision_hulls {

/// Corners in order.
using ConvexPolygon = std::vector<Eigen::Vector3d>;

/// Keeps the part of the polygon where the affine function `inside(point)` is >= 0 (Sutherland & Hodgman). `scratch` saves allocations.
template <class Affine>
void clip(ConvexPolygon& polygon, const Affine& inside, ConvexPolygon& scratch) {
  scratch.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) scratch.push_back(a);
    if ((at_a < 0) != (at_b < 0)) scratch.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  polygon.swap(scratch);
}

/// The corner where a function is largest; the first one on a tie. The polygon must not be empty.
template <class Function>
const Eigen::Vector3d& largest(const ConvexPolygon& polygon, const Function& value) {
  std::size_t best = 0;
  double most = value(polygon[0]);
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const double here = value(polygon[i]);
    if (here > most) most = here, best = i;
  }
  return polygon[best];
}

}  // namespace collision_hulls
