// Fewer vertices for a hull, outward only: a limit on vertices must never uncover what the hull
// covered.
#pragma once

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// The smallest limit on vertices: with it, a box is always possible.
constexpr int kLeastVertices = 8;

/// A hull of at most `max_vertices` (at least kLeastVertices) vertices that contains `hull` and
/// protrudes little beyond it. It starts from an inner hull of well-chosen vertices and moves them
/// outward; the containment is checked (all vertices of `hull` lie within all faces of the result).
/// A sphere reduced to 64 vertices gains 7 % of its radius. If rounding spoils this, as for minute
/// hulls, the result is the smallest oriented box found. A hull within the limit is returned
/// unchanged. Deterministic. Throws kBadOption if max_vertices is too small, and kCancelled.
ConvexHull reduceVertices(const ConvexHull& hull, int max_vertices, const RunControl& control = {});

/// Whether a hull has more vertices than a limit allows; 0 is no limit.
bool exceedsCap(const ConvexHull& hull, int max_vertices);

/// reduceVertices() where the limit is exceeded, otherwise the hull; 0 is no limit. Throws as that.
ConvexHull capped(const ConvexHull& hull, int max_vertices, const RunControl& control = {});

/// The largest distance [m] from `hull` of a point of `outer`, which contains it. Throws
/// kCancelled.
double addedDistance(const ConvexHull& outer, const ConvexHull& hull,
                     const RunControl& control = {});

}  // namespace collision_hulls
