// Few hulls that protrude little: the question of a decomposition the other way round.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Hulls that cover a mesh, and how far they protrude.
struct BoundedHulls {
  std::vector<ConvexHull> hulls;
  double bound = std::numeric_limits<double>::infinity();  ///< [m]
};

/// Decomposes at a tolerance [m]. Of more hulls than the limit, only the number counts.
using HullsAt = std::function<BoundedHulls(double tolerance)>;

/// Of some decompositions at tolerances above `tolerance` [m], the one of at most `limit` hulls that protrudes least, or `best` if none
/// protrudes less. `count`: hulls at `tolerance`, more than the limit. Nothing is tried beyond best.bound or `most` [m].
BoundedHulls withinLimit(double tolerance, std::size_t count, std::size_t limit, double most, BoundedHulls best, const HullsAt& at);

}  // namespace collision_hulls
