// The method `certified`: few hulls that cover the surface and protrude no further than the tolerance, by proof.
//
//   1. cut the surface by planes until each piece's hull stays within the tolerance   (leaves)
//   2. merge near hulls, cheapest first, while their common hull does                 (hull tree)
//   3. reduce vertices to the cap, outward; a hull that then protrudes too far gives way to its children
//
// It is the paper's hierarchy (Mamou & Ghorbel 2009: clusters merged under a cost of concavity and compactness) with the true
// protrusion, the one-sided Hausdorff distance to the solid, in place of ray concavity, with clusters whose borders may cut
// triangles, and with merges between any hulls that are near, neighbours on the surface or not.
#pragma once

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// Hulls by steps 1 to 3. Only what could not be cut, or a cap, leaves a hull beyond the tolerance. See decompose().
Decomposition certified(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control = {});

/// Steps 1 and 2 with leaves for `tolerance` [m] > 0, also when their vertices are capped (0: no cap), merged on up to a single root: any
/// cut at a larger tolerance, or to any number of hulls, is then a matter of microseconds. Bounds are those of the search, within 2 % of
/// the tolerance (above it 5 % of the bound) of the truth. Deterministic. Throws kEmptyMesh, kBadOption, kCancelled.
HullTree hullTree(const RepairedMesh& mesh, double tolerance, int max_vertices = 0, const RunControl& control = {});

}  // namespace collision_hulls
