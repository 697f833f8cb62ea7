// Qhull behind three plain values. Nothing else includes it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Qhull's hull of points that span three dimensions; nullopt if Qhull gives up or its result is not a closed 2-manifold. Vertices are
/// among the points; face i belongs to triangle i and has not been measured against the points yet. Throws kCancelled.
std::optional<ConvexHull> qhull(const std::vector<Eigen::Vector3d>& points, const RunControl& control = {});

}  // namespace collision_hulls
