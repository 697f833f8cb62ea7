// Whether two triangles of a mesh meet only where they have to.
#pragma once

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Whether triangles `t` and `u` certainly have no point in common but the corners, or the edge, that they share by index. False if they
/// meet elsewhere, if they share all three corners, and if it is too close to tell in double precision. `extent`: the mesh's [m].
bool meetOnlyAsNeighbours(const TriangleMesh& mesh, int t, int u, double extent);

}  // namespace collision_hulls
