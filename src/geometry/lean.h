// Ties, settled by position. Parts are full of symmetry, and between a plane and its mirror image rounding would choose, which changes when
// the mesh is turned. A slight preference that varies smoothly from place to place chooses instead.
#pragma once

#include <Eigen/Core>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// A unit vector that no symmetry of a part along the axes leaves as it is.
inline const Eigen::Vector3d& aslant() {
  static const Eigen::Vector3d direction = Eigen::Vector3d(0.61, 0.37, 0.23).normalized();
  return direction;
}

/// In [-1, 1] for points within `size` of the origin.
inline double lean(const Eigen::Vector3d& p, double size) {
  return size > 0 ? aslant().dot(p) / size : 0;
}

/// The same for planes, whichever way the normal points.
inline double lean(const HalfSpace& plane, double size) {
  const double along = lean(plane.normal, 1);
  return (lean(plane.offset * plane.normal, size) + along * along) / 2;
}

}  // namespace collision_hulls
