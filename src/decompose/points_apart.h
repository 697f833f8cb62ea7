// A lower bound of the number of hulls that holds however the surface is cut.
#pragma once

#include "collision_hulls/check/solid.h"
#include "decompose/surface_groups.h"

namespace collision_hulls {

/// Whether points of the mesh were found, one of each group, no two of which any hull may hold, as the way between them leaves the solid
/// by more than the tolerance [m]: then no cover has fewer hulls. Looks at few points, and at covers by few groups alone; false says
/// nothing.
bool isLeast(const Cover& cover, const TriangleMesh& mesh, const Solid& solid, double tolerance);

}  // namespace collision_hulls
