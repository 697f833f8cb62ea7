// Quickhull for the many small hulls of a decomposition, where Qhull's set-up and generality cost most of the time.
#pragma once

#include <optional>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Of points that lie in one plane quickhull takes some for vertices that are no corners; a second run leaves them out.
enum class Corners { kNeeded, kAsFound };

/// The hull of points about the origin that span three dimensions: vertices, triangles and one face per triangle, face i being
/// that of triangle i (faces moved out by what rounding may have left beyond them). nullopt where rounding would decide
/// something (a sliver of a face, a horizon that does not close, a dent): then a slower and more careful builder is needed.
std::optional<ConvexHull> quickhull(const std::vector<Eigen::Vector3d>& points, const RunControl& control = {},
                                    Corners corners = Corners::kNeeded);

}  // namespace collision_hulls
