// Walls of which there is one copy, found by what is closed without them.
#pragma once

#include <vector>

#include "base/looks.h"

namespace collision_hulls {

/// Leaves out patches, smallest first, while that leaves fewer odd edges: edges where the number of triangles is odd, as no closed surface
/// has them. `edges`: per edge where patches meet, those with an odd number of triangles there, each once; `areas` [m^2]: per patch.
/// Returns 1 for patches left out.
std::vector<char> leftOut(const std::vector<std::vector<int>>& edges, const std::vector<double>& areas, Looks& look);

}  // namespace collision_hulls
