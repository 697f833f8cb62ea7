// The hull tree of a mesh, cached between runs.
#pragma once

#include <string>

#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/mesh/repair.h"
#include "pipeline/cache.h"

namespace collision_hulls {

struct CachedTree {
  HullTree tree;
  bool found = false;  ///< in the cache
};

/// Takes the tree from the cache, or builds and stores it. `file` and `row` as for treeKey(); leaves for `tolerance` [m].
CachedTree cachedTree(const std::string& file, const ElementReport& row, const RepairedMesh& mesh, const Options& options, double tolerance,
                      Cache& cache, const RunControl& control);

}  // namespace collision_hulls
