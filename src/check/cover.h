// Which of a mesh's triangles a hull set leaves uncovered: the common part of measuring and of mending.
#pragma once

#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

struct UncoveredTriangle {
  int triangle = 0;
  double distance = 0;  ///< [m] largest distance to the hulls over what they leave of the triangle; see uncovered()
};

/// The triangles that are not wholly within the union of the hulls, in ascending order.
std::vector<UncoveredTriangle> uncoveredTriangles(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls,
                                                  const RunControl& control = {});

}  // namespace collision_hulls
