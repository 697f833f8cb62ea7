// Caps the number of hulls.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Merges hulls, cheapest pair first, until at most `max_hulls` (at least 1) are left. A pair costs the edge length of a cube with the
/// volume that its common hull adds, plus a small share of the union's diagonal: among pairs that add no volume, small and near ones merge
/// first. Pairs are sought among the nearest bounding boxes, whether or not the hulls touch. The result is ordered by the first hull in
/// each union. O(K^2) box distances for K hulls. Deterministic. Throws kCancelled.
std::vector<ConvexHull> capHulls(const std::vector<ConvexHull>& hulls, int max_hulls, const RunControl& control);

}  // namespace collision_hulls
