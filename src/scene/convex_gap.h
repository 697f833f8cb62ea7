// The distance between convex bodies, between two bounds that hold whatever rounding does to the search.
#pragma once

#include <Eigen/Geometry>
#include <limits>

namespace collision_hulls {

using PointMatrix = Eigen::Matrix3Xd;  ///< a point in each column; the body is their convex hull

/// at_least <= distance <= at_most [m]; at_least is 0 where the bodies overlap. Each bound is a computation of a few sums from a plane
/// that parts the bodies, or from two points of theirs.
struct Gap {
  double at_least = 0;
  double at_most = std::numeric_limits<double>::infinity();
  /// The normal of a plane that proves at_least, of unit length, from b towards a. Zero where there is none, or b is not convex.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

/// Both in one frame, of one point at least. Stops when at_least reaches `enough`, and else when the bounds differ by less than 1e-6 of the
/// distance. Gilbert, Johnson, Keerthi 1988.
Gap convexGap(const Eigen::Ref<const PointMatrix>& a, const Eigen::Ref<const PointMatrix>& b,
              double enough = std::numeric_limits<double>::infinity());

}  // namespace collision_hulls
