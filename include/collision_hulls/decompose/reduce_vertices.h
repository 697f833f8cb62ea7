// Fewer vertices for a hull, outward only.
#pragma once

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

struct ReducedHull {
  ConvexHull hull;   ///< contains the given one
  double added = 0;  ///< [m] largest distance of its points to the given hull (of its vertices: distance is convex)
};

/// A hull of at most `max_vertices` (>= 8) vertices that contains `hull`: faces are dropped, those first whose loss adds least.
/// A hull that has no more vertices is returned as it is. Deterministic, thread safe.
ReducedHull reduceVertices(const ConvexHull& hull, int max_vertices);

}  // namespace collision_hulls
