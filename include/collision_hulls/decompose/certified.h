// The method `certified`: few hulls that cover the surface and, provably, protrude no further than
// the tolerance.
//
//   1. split the surface by planes until each piece's hull stays within the tolerance   (leaves);
//      if this gives few hulls, split in other ways as well and keep the best result
//   2. merge hulls, cheapest first, while their common hull stays within it, also after its
//      vertices are reduced (outward)
//   3. search: dissolve some hulls and merge again
//   4. on request, keep merging up to a single root                                   (hull tree)
//
// This is the paper's hierarchy (Mamou & Ghorbel 2009: merging clusters by a cost of concavity and
// compactness) with three changes: the true protrusion, i.e. the one-sided Hausdorff distance to
// the solid, replaces ray concavity; cluster borders may divide triangles; and any hulls that are
// near each other may merge, neighbours on the surface or not. doc/certified.md has the proof, the
// steps and the constants.
#pragma once

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// The hulls of steps 1 to 3; if their number is limited, those of a cut of the tree or of a cover
/// at a larger tolerance, whichever protrude less. A hull exceeds the tolerance only if its piece
/// could not be split or a limit forces it to. `method` is ignored. Throws as decompose() with this
/// method.
Decomposition certified(const RepairedMesh& mesh, const DecomposeOptions& options,
                        const RunControl& control = {});

/// The hulls of certified() as leaves, merged up to a single root. A cut of the tree at a larger
/// tolerance, or with any number of hulls, then takes microseconds. The tree's hulls are not
/// limited, neither in vertices nor in number (but its leaves stay within the tolerance even after
/// their vertices are reduced); `method` is ignored. Bounds are within a few per cent of the truth.
/// Deterministic. Throws kEmptyMesh, kBadOption (as decompose()), kCancelled.
HullTree hullTree(const RepairedMesh& mesh, const DecomposeOptions& options,
                  const RunControl& control = {});

}  // namespace collision_hulls
