// The tree is built without a cap on hulls: caps choose a cut, so one tree serves them all.
#include "pipeline/cached_tree.h"

#include <utility>

#include "collision_hulls/decompose/certified.h"

namespace collision_hulls {

CachedTree cachedTree(const std::string& file, const ElementReport& row, const RepairedMesh& mesh, const Options& options, double tolerance,
                      Cache& cache, const RunControl& control) {
  const std::string key = treeKey(row, file, options, tolerance);
  if (std::optional<HullTree> known = cache.findTree(key)) return {std::move(*known), true};
  HullTree tree = hullTree(mesh, {options.method, tolerance, 0, options.max_vertices, options.seed, options.effort, options.fill}, control);
  cache.storeTree(key, tree);
  return {std::move(tree), false};
}

}  // namespace collision_hulls
