// What no robot has, and what would overflow in products of coordinates.
#pragma once

#include <Eigen/Geometry>

namespace collision_hulls {

constexpr double kFurthestOrigin = 1e6;  // [m] along each axis

/// NaN is, too.
inline bool isFarAway(const Eigen::Vector3d& origin) {
  return !(origin.array().abs() <= kFurthestOrigin).all();
}

/// Or that turns by no finite angle.
inline bool isFarAway(const Eigen::Isometry3d& pose) {
  constexpr double kLargestEntry = 1.001;  // of a rotation, with its rounding
  return isFarAway(Eigen::Vector3d(pose.translation())) || !(pose.linear().array().abs() <= kLargestEntry).all();
}

}  // namespace collision_hulls
