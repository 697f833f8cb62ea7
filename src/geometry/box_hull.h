// Boxes along the axes, as hulls.
#pragma once

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// The box between two corners [m].
ConvexHull hullOfBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// The box about the origin with these sides [m].
ConvexHull hullOfBox(const Eigen::Vector3d& sides);

}  // namespace collision_hulls
