// How far a point is from a segment.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace collision_hulls {

/// [m^2] From the segment between a and b, which may be one point.
inline double squaredSegmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return (p - a - share * along).squaredNorm();
}

}  // namespace collision_hulls
