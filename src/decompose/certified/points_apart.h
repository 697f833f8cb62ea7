// A lower bound on the number of hulls, valid for any way of splitting the surface. Two points are
// *apart* if no hull that fits can hold both.
#pragma once

#include "collision_hulls/measure/solid.h"
#include "decompose/certified/surface_groups.h"

namespace collision_hulls {

/// Whether some points of the mesh, one per group, were found of which no two can be in one hull
/// because the segment between them leaves the solid by more than the tolerance [m]. If so, no
/// cover has fewer hulls. Tries few points, and only covers with few groups; false says nothing.
bool isLeast(const Cover& cover, const TriangleMesh& mesh, const Solid& solid, double tolerance);

}  // namespace collision_hulls
