// How far a mesh that need not be convex protrudes from a solid, with proof.
#pragma once

#include "collision_hulls/control.h"
#include "collision_hulls/measure/measures.h"

namespace collision_hulls {

/// The largest distance to the solid over a mesh's triangles. The bound exceeds what was found by 1 %, or by `gap` [m] if that is more,
/// unless the search does not converge.
Protrusion largestOnMesh(const TriangleMesh& mesh, const Solid& solid, double gap, const RunControl& control = {});

/// The same over all points of one solid, its inside included. `mesh`: the triangles that `body` was made from.
Protrusion meshProtrusion(const TriangleMesh& mesh, const Solid& body, const Solid& solid, double gap, const RunControl& control = {});

}  // namespace collision_hulls
