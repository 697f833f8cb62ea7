// Fewer vertices for a hull, outward only: a cap on vertices must never uncover what the hull covered.
#pragma once

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

struct ReducedHull {
  ConvexHull hull;
  double added_distance = 0;  ///< [m] largest distance of a point of it to the hull that it stands for
};

/// A hull of at most `max_vertices` (at least 8) vertices that contains `hull` (checked) and protrudes little beyond it: edges
/// are collapsed, cheapest first, into a new vertex outside (progressive hulls, Sander et al. 2000, kept convex). Where
/// rounding spoils that, the smallest oriented box found. A hull that has no more vertices than that is returned as it is.
/// Deterministic. Thread safe. Throws kBadOption for max_vertices < 8.
ReducedHull reduceVertices(const ConvexHull& hull, int max_vertices);

}  // namespace collision_hulls
