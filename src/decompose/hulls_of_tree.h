// A decomposition taken from a hull tree instead of computed anew.
#pragma once

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// The hulls of the coarsest cut that keeps the tolerance even after their vertices are reduced (leaves count as keeping it), or of a
/// coarser one where their number is capped. `method`, `effort` and `seed` are the tree's and ignored here.
Decomposition hullsOfTree(const HullTree& tree, const DecomposeOptions& options);

}  // namespace collision_hulls
