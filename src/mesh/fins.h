// Sheets that hang on a surface which is whole without them, on its outside or within.
#pragma once

#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"
#include "mesh/orient.h"

namespace collision_hulls {

/// Per triangle: 1 where it is of a fin, which encloses nothing. A fin is a patch that has open edges, and non-manifold ones at each of
/// which the other triangles run along it equally often in both directions; what would close it is a tenth of its area or more. Triangles
/// to turn count as turned over.
///
/// A wall that two solids share is a fin, too: a patch without open edges of triangles whose `surplus` (of copies that face their way, over
/// those that face the other) is zero, hanging likewise where all walls are left out.
std::vector<char> findFins(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, const std::vector<int>& surplus);

}  // namespace collision_hulls
