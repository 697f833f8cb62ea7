// The dual graph S* of a mesh: a vertex per triangle, an edge per pair of triangles that share a
// mesh edge.
#pragma once

#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct DualEdge {
  int v = 0, w = 0;   ///< triangles, v < w
  double border = 0;  ///< [m] length that leaves the perimeter when v and w are united, counted once
};

/// The edges of S*, sorted by (v, w), one per pair. Where k > 2 triangles meet at a non-manifold
/// edge, all of them are neighbours (in very large fans only of the next 8 by index, to save
/// memory). Each of these P pairs has a border of k / (2 P) times the edge's length: once all k
/// triangles are in one cluster the edge has left its perimeter, which never becomes negative on
/// the way. Time O(T log T).
std::vector<DualEdge> dualGraph(const TriangleMesh& mesh);

}  // namespace collision_hulls
