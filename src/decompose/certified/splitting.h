// Top down: splits a mesh's surface by planes until every piece's hull fits, i.e. protrudes no
// further than the tolerance. The pieces are the leaves of the hierarchy that merging.h builds.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "collision_hulls/mesh/repair.h"
#include "decompose/certified/block.h"
#include "decompose/certified/plane_score.h"
#include "decompose/certified/protrusion_oracle.h"

namespace collision_hulls {

struct SplitOptions {
  ScoreWeights weights;
  int max_vertices = 0;             ///< cap for a leaf's hull, which must stay within the tolerance when capped as well; 0: no cap
  bool fill = false;                ///< cover the solid, not only its surface
  std::size_t most_leaves = 5000;   ///< per part that is split on its own; once reached, the rest is left whole
  std::size_t most_in_all = 10000;  ///< of the mesh; parts get shares in proportion to their areas

  /// The largestSide() of all of the mesh. If it is given, each piece is split by its own if it has
  /// one, regardless of scores.
  std::optional<HalfSpace> largest_side = std::nullopt;
};

/// A block and the hull of its points.
struct Leaf {
  Block block;
  ConvexHull hull;
  std::shared_ptr<const ConvexHull> reduced = nullptr;  ///< the hull with its vertices capped, if that is what fits
  bool fits = false;                                    ///< no: it could not be split further, or not in time,
  bool is_surplus = false;                              ///< or was not, as there are the most leaves already
};

/// Splits a mesh into leaves whose blocks make up the whole surface (including loose segments). By
/// the oracle's account each hull stays within the tolerance, unless its piece could not be split
/// further, or the deadline of the oracle's control passed. The order is fixed. Calls `progress` with the finished share of the area.
std::vector<Leaf> splitIntoLeaves(const RepairedMesh& mesh, ProtrusionOracle& oracle, const SplitOptions& options,
                                  const std::function<void(double)>& progress);

}  // namespace collision_hulls
