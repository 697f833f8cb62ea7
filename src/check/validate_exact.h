// Distances by our own computation, which FCL's answers are checked by. Brute force: for the few answers that are in doubt.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "check/fcl_queries.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

constexpr double kFurthest = std::numeric_limits<double>::infinity();

/// Distance from p to the hull, as a solid. Exact, also for points within rounding of a face's plane.
double pointDistance(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The point of the hull, as a solid, that is nearest to p. Exact.
Eigen::Vector3d nearestPoint(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The corners of what two bodies have in common, and their mean; none where they do not overlap.
std::vector<Eigen::Vector3d> commonPoints(const ConvexHull& a, const ConvexHull& b);

/// Distance from the mesh's surface to the body, as a solid: 0 where they meet or where part of the surface is inside the body.
/// Exact where it is below `limit`, else `limit`. O(triangles of the mesh), and of the body for each that is near.
double distanceToBody(const TriangleMesh& mesh, const ConvexHull& body, double limit = kFurthest);

/// Distance between two bodies, 0 where they overlap. Exact.
double bodyDistance(const ConvexHull& a, const ConvexHull& b);

/// Whether FCL's nearest points prove its answer to be within `tolerance`: each point lies in its body, so that the bodies
/// are no further apart, and the planes through the points, across the line between them, have the bodies on either side.
bool proved(const FclAnswer& answer, const ConvexHull& first, const ConvexHull& second, double tolerance);

}  // namespace collision_hulls
