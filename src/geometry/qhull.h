// Qhull behind three plain values. The only file pair that sees it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// The hull of points that span three dimensions, as Qhull finds it; nullopt where Qhull gives up or its result is not a
/// closed 2-manifold. Vertices are among the points; face i is that of triangle i, not yet measured against them.
std::optional<ConvexHull> qhull(const std::vector<Eigen::Vector3d>& points);

}  // namespace collision_hulls
