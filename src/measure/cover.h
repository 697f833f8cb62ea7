// Which of a mesh's triangles a hull set leaves uncovered: used both to measure and to complete a cover.
#pragma once

#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// The triangles not wholly inside the union of the hulls, in ascending order.
std::vector<int> uncoveredTriangles(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls, const RunControl& control = {});

/// What the hulls leave of the surface, exactly but for rounding, as convex polygons in the order of their triangles.
std::vector<std::vector<Eigen::Vector3d>> uncoveredPolygons(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls,
                                                            const RunControl& control = {});

}  // namespace collision_hulls
