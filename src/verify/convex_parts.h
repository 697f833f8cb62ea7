// A mesh file that holds convex bodies, one or many, told apart from one that does not.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct ConvexParts {
  std::vector<ConvexHull> hulls;  ///< of the closed components that are convex up to some millionths of their size
  TriangleMesh rest;              ///< all other triangles
  std::size_t rest_parts = 0;     ///< components in `rest`
  double beyond = 0;              ///< [m] how far lines without area that were left out stick out of the hulls
};

/// Nothing is welded, so that the two sides of a thin plate stay apart.
ConvexParts convexParts(const TriangleMesh& mesh, const RunControl& control = {});

}  // namespace collision_hulls
