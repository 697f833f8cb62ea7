// Hulls that are evaluated once and mostly thrown away.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "geometry/quickhull.h"

namespace collision_hulls {

/// A hull of points near the origin with one face per triangle, usually as quickhull leaves it. If points are coplanar its faces may lie
/// further out than those of the exact hull, by up to a millionth of its size; its vertices are points all the same. Throws kCancelled.
ConvexHull roughHull(const std::vector<Eigen::Vector3d>& points, Corners corners = Corners::kNeeded, const RunControl& control = {});

}  // namespace collision_hulls
