// Top down: a mesh's surface cut by planes until every piece's hull stays within the tolerance.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "collision_hulls/mesh/repair.h"
#include "decompose/block.h"
#include "decompose/plane_score.h"
#include "decompose/protrusion_oracle.h"

namespace collision_hulls {

struct CutOptions {
  ScoreWeights weights;
  int max_vertices = 0;             ///< of a leaf's hull, which has to fit also when reduced to so many; 0: no cap
  bool fill = false;                ///< cover the solid, not its surface alone
  bool largest_side_first = false;  ///< by largestSide() where it finds one, whatever other planes score
  std::size_t most_leaves = 5000;   ///< of a part that is cut on its own; beyond them the rest is left uncut
};

/// A block and the hull of its points.
struct Leaf {
  Block block;
  ConvexHull hull;
  std::shared_ptr<const ConvexHull> reduced = nullptr;  ///< the same with its vertices capped, where that is what fits
};

/// Leaves whose blocks make up the whole surface (loose segments included); each hull fits in the eyes of the oracle unless its piece
/// could not be cut any more. In a fixed order. Calls `progress` with the share of the area that is done.
std::vector<Leaf> cutIntoLeaves(const RepairedMesh& mesh, ProtrusionOracle& oracle, const CutOptions& options,
                                const std::function<void(double)>& progress);

}  // namespace collision_hulls
