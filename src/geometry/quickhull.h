// Quickhull for the many small hulls of a decomposition, where Qhull's set-up and generality would take most of the time.
#pragma once

#include <optional>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Among coplanar points quickhull keeps some vertices that are not corners. kNeeded runs it again without them.
enum class Corners { kNeeded, kAsFound };

/// The hull of points about the origin that span three dimensions: vertices, triangles, and one face per triangle (face i belongs to
/// triangle i and is moved out by what rounding may have left beyond it). nullopt if rounding would decide something (a sliver, a horizon
/// that does not close, a dent): the caller then needs a slower, more careful builder. `sources`, if asked for, tells which point each
/// vertex is.
std::optional<ConvexHull> quickhull(const std::vector<Eigen::Vector3d>& points, const RunControl& control = {},
                                    Corners corners = Corners::kNeeded, std::vector<int>* sources = nullptr);

}  // namespace collision_hulls
