// Regions that a closed surface winds about a negative number of times.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Per triangle of a closed surface (every edge used equally often in both directions): 1 if the winding number may be negative somewhere
/// just in front of it, 0 if that is proved not to be.
std::vector<char> mayFaceInverted(const TriangleMesh& surface, const RunControl& control);

}  // namespace collision_hulls
