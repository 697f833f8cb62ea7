// From a cover to the tree of hulls above it: every level of detail at once. A *cut* through the
// tree is a set of nodes with exactly one on each path from the root to a leaf
// (collision_hulls/decompose/hull_tree.h).
#pragma once

#include "collision_hulls/decompose/hull_tree.h"
#include "decompose/certified/surface_groups.h"

namespace collision_hulls {

enum class TreeBounds {
  kProved,     ///< close ones
  kEstimated,  ///< for the hulls' surfaces: close, but a pocket inside may be further from the solid
  kDiagonal    ///< of the hull's box, which takes no time
};

/// The groups as leaves, merged up to a single root. At any tolerance, the coarsest cut of the tree
/// is about as good as a new merge would be. Deterministic. Calls `progress` with the share of
/// merges made.
HullTree treeAbove(const Cover& cover, ProtrusionOracle& oracle, TreeBounds bounds, const std::function<void(double)>& progress);

}  // namespace collision_hulls
