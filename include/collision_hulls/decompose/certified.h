// The method `certified`: few hulls that cover the surface and protrude no further than the tolerance, by proof.
//
//   1. cut the surface by planes until each piece's hull stays within the tolerance   (leaves);
//      where few hulls come of it cut in other ways, too, and keep the best
//   2. merge hulls, cheapest first, while their common hull does, also with its vertices reduced to the cap, outward
//   3. search: dissolve some of them, and merge anew
//   4. on demand merge on, up to a single root                                        (hull tree)
//
// It is the paper's hierarchy (Mamou & Ghorbel 2009: clusters merged under a cost of concavity and compactness) with the true
// protrusion, the one-sided Hausdorff distance to the solid, in place of ray concavity, with clusters whose borders may cut
// triangles, and with merges between any hulls that are near, neighbours on the surface or not.
#pragma once

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// Hulls by steps 1 to 3, or cut from the tree where their number is capped. Only what could not be cut, or a cap, leaves a hull beyond the
/// tolerance. On all threads of the caller's TBB arena; their number does not change the result. See decompose().
Decomposition certified(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control = {});

/// The hulls of certified() as leaves, merged on up to a single root: a cut at a larger tolerance, or to any number of hulls, is then
/// a matter of microseconds. Vertices are not capped (but leaves fit also when they are), nor hulls; `method` is ignored. Bounds are
/// within a few per cent of the truth. Deterministic. Throws kEmptyMesh, kBadOption, kCancelled.
HullTree hullTree(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
