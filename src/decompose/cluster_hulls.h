// From clusters of triangles to the hulls that cover them.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// The hull of each cluster's corners. Every loose segment that lies in none of them is given to the nearest hull, which is built
/// again with its ends; without any cluster the loose segments have a hull of their own. Deterministic; ties go to the first.
/// Throws kCancelled.
std::vector<ConvexHull> clusterHulls(const RepairedMesh& mesh, const std::vector<std::vector<int>>& clusters, const RunControl& control);

/// What clusterHulls does with loose segments. `hulls` must not be empty.
void addLoose(std::vector<ConvexHull>& hulls, const std::vector<Segment>& loose, const RunControl& control);

}  // namespace collision_hulls
