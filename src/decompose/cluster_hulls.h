// From clusters of triangles to hulls that cover them.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// The hull of each cluster's corners. A loose segment outside all hulls is added to the nearest one; without clusters, the loose segments
/// get a hull of their own. Deterministic; ties go to the first hull. Throws kCancelled.
std::vector<ConvexHull> clusterHulls(const RepairedMesh& mesh, const std::vector<std::vector<int>>& clusters, const RunControl& control);

/// The step of clusterHulls that handles loose segments. `hulls` must not be empty.
void addLoose(std::vector<ConvexHull>& hulls, const std::vector<Segment>& loose, const RunControl& control);

}  // namespace collision_hulls
