// What a result would look like with fewer hulls.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// A tree whose leaves are the hulls of a result, in their order, merged pair by pair up to one. `bound` [m]: proved of the result's
/// protrusion, and so of the leaves'. A merged hull's is proved from that: no point of it is further from the result's hulls than what is
/// added. It needs neither the mesh nor its solid, and is never too small; decomposing at that tolerance may do better. Throws what
/// convexHull() throws.
HullTree coarserHulls(const std::vector<ConvexHull>& hulls, double bound, const RunControl& control = {});

/// Proved: the largest distance [m] of a point of `hull` from the nearest of `parts`; too large by a few percent, or more where that would
/// take long. `hull` is the convex hull of the parts.
double furthestFrom(const std::vector<const ConvexHull*>& parts, const ConvexHull& hull);

}  // namespace collision_hulls
