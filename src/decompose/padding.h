// Hulls with a safety distance around them.
#pragma once

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// A hull of at most `max_vertices` (0: no cap) vertices, all of them single-precision numbers, that holds every point within `padding`
/// [m], > 0, of the given one. Without a cap its points are no further from that one than 1.03 paddings and rounding. With 64 vertices they
/// are up to 1.2 paddings away, and up to 1.45 where the hull itself has so many that its edges stay sharp (a rod of 32 sides).
/// Throws kCancelled.
ConvexHull padded(const ConvexHull& hull, double padding, int max_vertices, const RunControl& control = {});

/// Whether `outer` holds every point within `padding` [m] of `inner`, up to rounding (1e-12 of the coordinates).
bool holdsPadding(const ConvexHull& outer, const ConvexHull& inner, double padding);

}  // namespace collision_hulls
