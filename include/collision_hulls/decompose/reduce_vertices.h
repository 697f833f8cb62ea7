// Fewer vertices for a hull, outward only: a cap on vertices must never uncover what the hull covered.
#pragma once

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Of a cap on vertices: a box is always possible.
constexpr int kLeastVertices = 8;

/// A hull of at most `max_vertices` (at least kLeastVertices) vertices that contains `hull` (checked: all of its vertices lie within all of
/// the result's faces) and protrudes little beyond it: an inner hull of well-chosen vertices, moved outward. A sphere with 64 vertices
/// gains 7 % of its radius. Where rounding spoils that, as for hulls that are next to nothing, the smallest oriented box found. A hull that
/// has no more vertices than that is returned as it is. Deterministic. Thread safe. Throws kBadOption for fewer.
ConvexHull reduceVertices(const ConvexHull& hull, int max_vertices);

/// The largest distance [m] of a point of `outer` to `hull`, which it contains.
double addedDistance(const ConvexHull& outer, const ConvexHull& hull);

}  // namespace collision_hulls
