// A linear program in three unknowns, for points that must lie beyond a few planes.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// The point that lies on or beyond every plane (distance >= 0) and lowest along `up`, within a cube of half side `reach` around `middle`;
/// nullopt if there is none. Exact up to rounding.
std::optional<Eigen::Vector3d> lowestPointBeyond(const std::vector<HalfSpace>& planes, const Eigen::Vector3d& up,
                                                 const Eigen::Vector3d& middle, double reach);

}  // namespace collision_hulls
