// The largest distance to a solid over the surface of a convex hull, or over any other triangles.
#pragma once

#include <limits>
#include <vector>

#include "collision_hulls/measure/measures.h"
#include "measure/outside_distance.h"

namespace collision_hulls {

struct SurfaceQuery {
  double floor = 0;                                          ///< [m] distances up to this do not matter
  double gap = 0;                                            ///< [m] > 0: how far the bound may exceed max(found, floor)
  double ceiling = std::numeric_limits<double>::infinity();  ///< [m] the search ends once it finds a larger distance
  int halvings = std::numeric_limits<int>::max();            ///< of patches; afterwards the search ends with what it has,
  int patience = std::numeric_limits<int>::max();            ///< or after this many
  double low = 0;                                            ///< [m] if its bound is at most this
  const OutsideDistance* known = nullptr;                    ///< its knowledge of the solid settles patches
  const std::vector<char>* settled = nullptr;                ///< triangles of the hull that are known to be within floor + gap
};

/// Branch and bound over the hull's triangles. The bound is infinite if the ceiling ended the search. Near openings the solid's border is
/// not surface, and the distance to the surface jumps across it. A patch around a point inside is assumed to be as near to the solid as
/// that point's ball, even if it may reach across.
Protrusion largestOnSurface(const ConvexHull& hull, const Solid& solid, const SurfaceQuery& query, const RunControl& control);

/// The same over the triangles of any surface.
Protrusion largestOnSurface(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles, const Solid& solid,
                            const SurfaceQuery& query, const RunControl& control);

}  // namespace collision_hulls
