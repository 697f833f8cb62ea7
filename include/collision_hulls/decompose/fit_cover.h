// From the hulls of a method to the hulls that are written: every original triangle covered, in single precision.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

struct FittedHulls {
  std::vector<ConvexHull> hulls;  ///< vertices are single-precision numbers
  double nudge = 0;               ///< [m] distance that every hull was grown by to absorb rounding
  std::size_t completed = 0;      ///< triangles that no hull held and that were added to one
  double blunted = 0;             ///< [m] furthest that a hull was made to reach as it was too sharp for its cap on vertices
};

/// Grows each hull outward by `margin` [m] (how far original points may lie from the repaired mesh: weld and reader's
/// rounding) plus what single precision needs, and rounds its vertices; then gives every triangle of `original` that the
/// union still fails to cover to the hull that grows least. After it uncovered(original, hulls) == 0.
/// At most `max_vertices` vertices a hull (0: no cap).
FittedHulls fitCover(const std::vector<ConvexHull>& hulls, const TriangleMesh& original, double margin, int max_vertices,
                     const RunControl& control = {});

}  // namespace collision_hulls
