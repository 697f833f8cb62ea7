// Top down: a mesh's surface cut by planes until every piece's hull stays within the tolerance.
#pragma once

#include <functional>
#include <vector>

#include "collision_hulls/mesh/repair.h"
#include "decompose/protrusion_oracle.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// A piece of surface, as the hull of its points, and a bound of how far that hull protrudes [m].
struct Leaf {
  ConvexHull hull;
  double protrusion = 0;
};

/// Leaves whose pieces make up the whole surface (loose points included), none further than the oracle's tolerance from the solid
/// unless its piece could not be cut any more; nor further if its hull is reduced to `max_vertices` (0: no cap). In a fixed order. Calls
/// `progress` with the share of the area that is done.
std::vector<Leaf> cutIntoLeaves(const RepairedMesh& mesh, ProtrusionOracle& oracle, int max_vertices,
                                const std::function<void(double)>& progress);

}  // namespace collision_hulls
