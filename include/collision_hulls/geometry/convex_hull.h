// Convex hulls of point sets: quickhull for what is in general position, Qhull for what is not.
//
// The guarantee: every hull is measured against the points it was built from, and its planes are moved out until each point
// lies within all of them. A hull is closed, outward, convex up to `slack`, and never thinner than it must be to be a body.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The half-space normal . x <= offset; normal of unit length, offset in metres.
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset = 0;
  double distance(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }  ///< > 0 outside
};

/// A convex polyhedron, as vertices, outward triangles and the half-spaces of its (merged) faces.
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;  ///< extreme points [m], each used by a triangle
  std::vector<Triangle> triangles;        ///< closed, outward; 2 * vertices - 4 of them
  std::vector<HalfSpace> faces;           ///< one per face: coplanar triangles share theirs; the hull is their intersection
  double thickness = 0;                   ///< [m] how far a degenerate input (point, line, plane) was made thicker; 0 if it was not
  double slack = 0;                       ///< [m] largest distance of a vertex beneath or above the face that it lies on
};

/// The convex hull of `points` (metres, any frame). Degenerate sets are thickened outward: a point becomes a small
/// tetrahedron-like body, a line a thin rod, a plane a thin plate, by the least amount that still gives a body whose faces
/// can be told apart in double precision (1e-6 of the set's extent; reported as `thickness`).
/// Deterministic. Thread safe. Throws kEmptyMesh for no point, kNonFiniteCoordinate for a NaN or an infinity, kCancelled.
ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points, const RunControl& control = {});

/// Volume [m^3] and bounding box of a hull.
double volume(const ConvexHull& hull);
Eigen::AlignedBox3d boundingBox(const ConvexHull& hull);

/// Whether p lies in the hull.
bool holds(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The hull moved by a rigid transform.
ConvexHull transformed(const ConvexHull& hull, const Eigen::Isometry3d& pose);

/// Largest distance of p beyond a face's plane [m]; <= 0 inside. Outside it is a lower bound of the distance to the hull.
double planeDistance(const ConvexHull& hull, const Eigen::Vector3d& p);

/// Euclidean distance from p to the hull [m], 0 inside. Exact.
double distance(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The hull's surface as a mesh.
TriangleMesh surface(const ConvexHull& hull);

}  // namespace collision_hulls
