// What a result would look like with fewer hulls, where it was cut from a hull tree: the cuts above it.
#pragma once

#include <memory>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// Hulls as they were written, which were cut from a tree. Lengths in metres.
struct CutHulls {
  const std::vector<ConvexHull>& hulls;
  double bound = 0;                     ///< proved of their protrusion
  double tolerance = 0;                 ///< that they were cut for
  int max_hulls = 0, max_vertices = 0;  ///< see DecomposeOptions
  double margin = 0;                    ///< see PreparedMesh
  double nudge = 0;                     ///< how far rounding outward moved them
};

/// A tree whose leaves are these hulls, in their order; the nodes above have the hulls that `tree` has there, their vertices reduced, with
/// the bounds that are proved of them, margin included. Null where the hulls are not the tree's first cut for the tolerance, since rounding
/// outward asked for another.
std::shared_ptr<const HullTree> coarserCuts(const HullTree& tree, const CutHulls& made);

}  // namespace collision_hulls
