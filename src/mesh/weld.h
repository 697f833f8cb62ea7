// Welding: joining vertices that lie at the same place.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct Welding {
  std::vector<int> representative;  ///< per vertex: the vertex that represents it (itself or an earlier one); -1 if no triangle uses it
  std::size_t joined = 0;           ///< vertices represented by another one
  double distance = 0;              ///< [m] largest distance of a vertex from its representative
};

/// Welds every vertex to the nearest earlier representative within `tolerance` [m]; a vertex without one becomes a representative itself.
/// Hence no vertex moves further than the tolerance, however long a chain of close vertices is, and the result depends only on distances
/// and on the order of the vertices, not on the axes.
Welding weld(const TriangleMesh& mesh, double tolerance, const RunControl& control);

}  // namespace collision_hulls
