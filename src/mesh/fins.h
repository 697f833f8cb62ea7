// Sheets that hang on a surface which is whole without them.
#pragma once

#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"
#include "mesh/orient.h"

namespace collision_hulls {

/// Per triangle: 1 where it is of a fin, which encloses nothing. A fin is a patch that has open edges, and non-manifold ones at each of
/// which the other triangles run along it equally often in both directions; what would close it is a tenth of its area or more. Triangles
/// to turn count as turned over.
std::vector<char> findFins(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented);

}  // namespace collision_hulls
