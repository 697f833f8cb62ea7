// From a method's hulls to the hulls that are written: in single precision, covering every original
// triangle.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

struct RoundedHulls {
  std::vector<ConvexHull> hulls;  ///< their vertices are single-precision numbers
  double nudge = 0;               ///< [m] distance by which every hull was grown to absorb rounding
  std::size_t completed = 0;      ///< triangles that no hull covered and that were added to one
  /// [m] furthest distance that a hull too sharp for its limit on vertices was extended
  double blunted = 0;
};

/// Grows each hull outward by `margin` [m] (how far original points may lie from the repaired mesh:
/// the weld tolerance plus the reader's rounding) and by what single precision needs, and rounds
/// its vertices. Any triangle of `original` that the union still does not cover is added to the
/// hull that has to grow least. Afterwards uncovered(original, hulls) == 0. Each hull has at most
/// `max_vertices` vertices (0: no limit). Throws kBadOption as reduceVertices(), kInternal if a
/// hull cannot be rounded or the triangles cannot be covered (as without any hull), kCancelled.
RoundedHulls roundOutward(const std::vector<ConvexHull>& hulls, const TriangleMesh& original,
                          double margin, int max_vertices, const RunControl& control = {});

}  // namespace collision_hulls
