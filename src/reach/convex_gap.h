// The distance between convex bodies as a pair of bounds, which hold whatever rounding does to the search.
#pragma once

#include <Eigen/Geometry>
#include <limits>

namespace collision_hulls {

using PointMatrix = Eigen::Matrix3Xd;  ///< a point in each column; the body is their convex hull

/// at_least <= distance <= at_most [m]; at_least is 0 if the bodies overlap. Each bound is a few sums away from its evidence: a separating
/// plane for at_least, two points of the bodies for at_most.
struct Gap {
  double at_least = 0;
  double at_most = std::numeric_limits<double>::infinity();
  /// Unit normal of the plane that proves at_least, from b towards a. Zero if there is none, or b is not convex.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

/// Both bodies are in one frame and have at least one point. Stops when at_least reaches `enough`, or when the bounds differ by less than
/// 1e-6 of the distance. Gilbert, Johnson, Keerthi 1988.
Gap convexGap(const Eigen::Ref<const PointMatrix>& a, const Eigen::Ref<const PointMatrix>& b,
              double enough = std::numeric_limits<double>::infinity());

}  // namespace collision_hulls
