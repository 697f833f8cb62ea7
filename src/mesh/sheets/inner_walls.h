// Walls inside a solid that is closed but for them.
#pragma once

#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"
#include "mesh/orient.h"

namespace collision_hulls {

/// Looks for inner walls in each component where a patch meets others so that they are not balanced (they do not use an edge equally often
/// in both directions), and where only sheets have open edges. `sheet`: per triangle, 1 if it is in a fin; see findFins().
///
/// If the component separates some space from the rest, its skin is what borders the outer space on one side alone. The skin is then turned
/// to face the outer space (`oriented.turn`), and all else of the component is marked in `sheet`.
void setInnerWallsApart(const TriangleMesh& mesh, const Edges& edges, OrientedPatches& oriented, std::vector<char>& sheet,
                        const RunControl& control);

}  // namespace collision_hulls
