// Our own distances, which FCL's answers are checked against. Brute force: for the few answers that are in doubt.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "query/fcl_queries.h"

namespace collision_hulls {

constexpr double kFurthest = std::numeric_limits<double>::infinity();

/// The distance from p to the hull, as a solid. Exact, even for points within rounding of a face's plane.
double pointDistance(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The point of the hull, as a solid, nearest to p. Exact.
Eigen::Vector3d nearestPoint(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The corners of the intersection of two bodies, and their mean; empty if they do not overlap.
std::vector<Eigen::Vector3d> commonPoints(const ConvexHull& a, const ConvexHull& b);

/// The distance from the mesh's surface to the body, as a solid: 0 if they meet or part of the surface is inside the body. Exact below
/// `limit`, else `limit`. O(triangles of the mesh), and O(triangles of the body) for each one that is near.
double distanceToBody(const TriangleMesh& mesh, const ConvexHull& body, double limit = kFurthest);

/// The distance between two bodies, 0 if they overlap. Exact.
double bodyDistance(const ConvexHull& a, const ConvexHull& b);

/// Whether FCL's nearest points prove its answer to within `tolerance`: each point lies in its body, so the bodies are no further apart;
/// and the bodies lie on either side of the planes through the points normal to the line between them, so they are no nearer.
bool proved(const FclAnswer& answer, const ConvexHull& first, const ConvexHull& second, double tolerance);

}  // namespace collision_hulls
