// The dual graph S* of a mesh: a vertex per triangle, an edge per pair of triangles that share a mesh edge.
#pragma once

#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct DualEdge {
  int v = 0, w = 0;   ///< triangles, v < w
  double border = 0;  ///< [m] length that the union of v and w no longer has on its perimeter, counted once
};

/// The edges of S*, sorted by (v, w), one per pair. Where k > 2 triangles meet at a mesh edge (not a manifold there), each is a
/// neighbour of all the others (of the 8 next by index, in fans so large that all pairs would cost memory), and the border of
/// its P pairs is k / (2 P) of the edge's length each: once all k are one cluster, the edge has left its perimeter, which
/// never becomes negative on the way. Time O(T log T).
std::vector<DualEdge> dualGraph(const TriangleMesh& mesh);

}  // namespace collision_hulls
