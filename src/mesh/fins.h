// Sheets that hang on a surface which is whole without them.
#pragma once

#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"

namespace collision_hulls {

/// Per triangle: 1 where it is of a fin, which encloses nothing. A fin is a patch (triangles connected across manifold edges) that has open
/// edges, and non-manifold ones at each of which the other triangles run along it equally often in both directions; what would close it is
/// a tenth of its area or more. Triangles marked in `turn` count as turned over.
std::vector<char> findFins(const TriangleMesh& mesh, const Edges& edges, const std::vector<char>& turn);

}  // namespace collision_hulls
