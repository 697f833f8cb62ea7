// A cap on the number of hulls.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Merges hulls, cheapest pair first, until no more than `max_hulls` (at least 1) are left. The cost of a pair is the side of a
/// cube of the volume that its union's hull adds, plus a small share of the union's diagonal, so that small and near hulls go
/// first where nothing is added. Pairs are sought among the nearest bounding boxes, whether or not the hulls touch. Order of
/// the result: by the first hull in each. O(K^2) box distances for K hulls. Deterministic. Throws kCancelled.
std::vector<ConvexHull> capHulls(const std::vector<ConvexHull>& hulls, int max_hulls, const RunControl& control);

}  // namespace collision_hulls
