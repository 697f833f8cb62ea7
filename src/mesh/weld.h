// Joining vertices that lie at the same place.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct Welding {
  std::vector<int> representative;  ///< per vertex: the vertex that stands for it, itself or one before it; -1 where no triangle uses it
  std::size_t joined = 0;           ///< vertices that another one stands for
  double distance = 0;              ///< [m] furthest distance of a vertex from its representative
};

/// Joins every vertex to the nearest earlier representative within `tolerance` [m]; a vertex without one becomes a
/// representative itself. So no vertex moves further than the tolerance however long a chain of close vertices is, and the
/// result depends on distances and on the order of the vertices alone, not on the axes.
Welding weld(const TriangleMesh& mesh, double tolerance);

}  // namespace collision_hulls
