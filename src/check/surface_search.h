// The largest distance to a solid over the surface of a convex hull.
#pragma once

#include <limits>

#include "check/outside_distance.h"
#include "collision_hulls/check/measures.h"

namespace collision_hulls {

struct SurfaceQuery {
  double floor = 0;                                          ///< [m] distances up to here do not matter
  double gap = 0;                                            ///< [m] the bound may exceed max(found, floor) by this; > 0
  double ceiling = std::numeric_limits<double>::infinity();  ///< [m] the search ends when a larger distance is found
  int halvings = std::numeric_limits<int>::max();            ///< of patches, then the search ends with what it has,
  int patience = std::numeric_limits<int>::max();            ///< or after so many
  double low = 0;                                            ///< [m] where its bound is no more than this
  const OutsideDistance* known = nullptr;                    ///< what it knows of the solid settles patches
};

/// Branch and bound over the hull's triangles. bound is infinite if the ceiling ended the search.
/// Near openings the border of the solid is no surface, and across it the distance to the surface jumps. A patch about a point inside
/// that may reach across is taken to be as near to the solid as the point's ball is.
Protrusion largestOnSurface(const ConvexHull& hull, const Solid& solid, const SurfaceQuery& query, const RunControl& control);

}  // namespace collision_hulls
