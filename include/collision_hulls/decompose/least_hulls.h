// How many hulls a mesh needs at least: a proved lower bound on what any decomposition can reach.
//
// For example:
//
//     const Solid solid(repair(mesh));
//     const std::size_t least = leastHulls(mesh, solid, options.tolerance, hulls);
//     std::cout << hulls.size() << " hulls, where fewer than " << least << " cannot do\n";
//
// What is proved: let convex sets of any kind, hulls of pieces or not, with any number of vertices,
// hold every point of the mesh's triangles, and let no point of them be further than the tolerance
// from S, the solid that the mesh represents (see Solid). Then there are at least that many sets.
// doc/certified.md, part 2, has the proof.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/measure/solid.h"

namespace collision_hulls {

/// The bound; at least 1. `mesh`: as it was read; `tolerance`: [m]. `known`: hulls that cover
/// the mesh within the tolerance, if there are any. They save work: points that share a hull are
/// not tested, and the search ends at their number. The bound grows with the effort, is 1 with
/// Effort::kInstant, and is often not the best possible. Deterministic, on any number of threads.
/// Throws kBadOption for a tolerance that is not a positive length, or below a millionth of the
/// mesh's diagonal; kEmptyMesh for a mesh without triangles; kIndexOutOfRange,
/// kNonFiniteCoordinate, kCancelled.
std::size_t leastHulls(const TriangleMesh& mesh, const Solid& solid, double tolerance,
                       const std::vector<ConvexHull>& known, Effort effort = Effort::kQuick,
                       const RunControl& control = {});

}  // namespace collision_hulls
