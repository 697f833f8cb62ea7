// Points that no hull can hold together.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "collision_hulls/measure/solid.h"

namespace collision_hulls {

/// Points are *apart* if their convex hull protrudes from the solid by more than the tolerance: no convex set within the tolerance holds
/// all of them. Thread safe.
class Apart {
 public:
  /// `size`: [m] an upper bound on the coordinates of all points, which their rounding errors grow with. `solid` must outlive this.
  Apart(const Solid& solid, double tolerance, double size);

  /// Whether two or three points are apart. True is proved; false says only that a limited search found no point that is far enough from
  /// the solid.
  bool operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  bool operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const;

 private:
  template <std::size_t N>
  bool search(const std::array<Eigen::Vector3d, N>& points) const;

  const Solid& solid_;
  const double tolerance_;
  const double proved_;  // [m] a distance above this proves that a point is further than the tolerance
};

}  // namespace collision_hulls
