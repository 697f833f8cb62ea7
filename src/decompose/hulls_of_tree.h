// A decomposition taken from a hull tree instead of computed anew.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"

namespace collision_hulls {

/// The hulls of the coarsest cut that keeps the tolerance even after their vertices are reduced (leaves count as keeping it), or of a
/// coarser one where their number is capped. `method`, `effort` and `seed` are the tree's and ignored here.
Decomposition hullsOfTree(const HullTree& tree, const DecomposeOptions& options);

/// [m] The tolerance that certified hulls are first decomposed or cut for, so that they keep `tolerance` after they are rounded outward.
/// `margin`: see PreparedMesh. `more` [m]: what else takes its share.
double firstAim(double tolerance, double margin, double more = 0);

/// [m] The least tolerance whose first aim is `aim`.
double toleranceForAim(double aim, double margin);

/// The same cuts, many of them through one tree: each hull's vertices are reduced only once. Not thread safe.
class TreeCutter {
 public:
  /// `tree` must outlive this object.
  TreeCutter(const HullTree& tree, int max_vertices) : tree_(tree), max_vertices_(max_vertices), known_(tree.nodes.size()) {}

  struct Cut {
    std::vector<int> nodes;
    double bound = 0;  ///< [m] proved of the hulls, their vertices reduced: no point of them is further from the solid of the tree's mesh
    bool capped = false;  ///< see Decomposition
  };
  /// See DecomposeOptions.
  Cut cut(double tolerance, int max_hulls);

  /// A node's hull, its vertices reduced.
  const ConvexHull& hull(int node) { return reduced(node).hull; }

  /// [m] The bounds of the inner nodes' hulls: the aims at which cuts without a cap change.
  std::vector<double> mergedBounds();

 private:
  struct Reduced {
    ConvexHull hull;
    double bound = 0;  // [m]
  };
  const Reduced& reduced(int node);
  std::vector<int> cutWithin(double tolerance);

  const HullTree& tree_;
  const int max_vertices_;
  std::vector<std::optional<Reduced>> known_;  // by node
};

}  // namespace collision_hulls
