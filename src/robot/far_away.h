// What no robot has, and what would overflow in products of coordinates.
#pragma once

#include <Eigen/Core>

namespace collision_hulls {

constexpr double kFurthestOrigin = 1e6;  // [m] along each axis

/// NaN is, too.
inline bool isFarAway(const Eigen::Vector3d& origin) {
  return !(origin.array().abs() <= kFurthestOrigin).all();
}

}  // namespace collision_hulls
