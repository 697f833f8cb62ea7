// Seams: open edges that lie along each other, a little too far apart for welding.
#pragma once

#include <optional>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"
#include "mesh/weld.h"

namespace collision_hulls {

/// `welding` and, on top of it, the ends of open edges that run along each other in opposite directions, end by end within `tolerance` [m];
/// nullopt if there are none. Only edges longer than twice the tolerance have partners, and no vertex comes to be represented by one
/// further than that from it: longer chains of partners stay as they are. `triangles` have the corners that `welding` gives them, and
/// `edges` are theirs. Near-linear, but where very many open edges are within the tolerance of one.
std::optional<Welding> weldSeams(const TriangleMesh& mesh, const std::vector<Triangle>& triangles, const Edges& edges, double tolerance,
                                 const Welding& welding, const RunControl& control);

}  // namespace collision_hulls
