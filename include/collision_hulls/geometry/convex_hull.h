// Convex hulls of point sets: quickhull for points in general position, Qhull for the rest.
//
// The guarantee: every hull is measured against the points it was built from, and its planes are
// moved outward until each point lies within all of them. A hull is closed, faces outward, is
// convex up to `slack`, and is no thicker than a body has to be.
//
// For example:
//
//     const ConvexHull hull = convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
//     const double sixth = volume(hull);            // [m^3]
//     const double gap = distance(hull, {1, 1, 1});  // [m] 2 / sqrt(3)
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
  /// > 0 outside
  double distance(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
};

/// A convex polyhedron: vertices, outward triangles, and the half-spaces of its (merged) faces.
/// convexHull() makes one from points, also from the vertices of another program's hull, which has
/// no faces. Functions that measure hulls refuse what check() refuses; all others expect what it
/// lets pass.
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;  ///< extreme points [m], each used by some triangle
  std::vector<Triangle> triangles;        ///< closed, outward; 2 * vertices - 4 of them
  /// one per face, shared by coplanar triangles; the hull is their intersection
  std::vector<HalfSpace> faces;
  /// [m] how much a degenerate input (point, line, plane) was thickened; 0 if it was not
  double thickness = 0;
  /// [m] largest distance of a vertex below or above a face it belongs to
  double slack = 0;
};

/// The convex hull of `points` (metres, any frame). Degenerate sets are thickened outward: a point
/// becomes a small body of six vertices, a line a thin rod, a plane a thin plate. The thickness is
/// the least that keeps the faces distinguishable in double precision: 1e-6 of the set's extent or
/// 1e-12 of the coordinates' size if that is larger, and for a point 1e-9 m at least. It is
/// reported as `thickness`. Deterministic. Throws kEmptyMesh if there are no points,
/// kNonFiniteCoordinate for a NaN or an infinity, kCancelled.
ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points, const RunControl& control = {});

/// Throws kEmptyMesh for a hull that has some of vertices, triangles and faces but not all (one
/// without any is empty and passes), kIndexOutOfRange for a triangle that names a vertex that is
/// not there, kNonFiniteCoordinate for a vertex or face that is not finite, kBadOption for a normal
/// that is not of unit length (to a millionth), kCancelled. The message has the hull's number.
/// Whether the three belong together is not looked at.
void check(const std::vector<ConvexHull>& hulls, const RunControl& control = {});

/// The volume [m^3] and the bounding box of a hull; 0 and empty for one without vertices.
double volume(const ConvexHull& hull);
Eigen::AlignedBox3d boundingBox(const ConvexHull& hull);

/// Whether p lies in the hull. Nothing lies in one without faces, and no point does whose
/// coordinates are not finite.
bool holds(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The hull moved by a rigid transform.
ConvexHull transformed(const ConvexHull& hull, const Eigen::Isometry3d& pose);

/// The largest signed distance of p from a face's plane [m]; <= 0 inside. Outside, it is a lower
/// bound on the distance to the hull. Infinite for a hull without faces, NaN for a point that is
/// not finite.
double planeDistance(const ConvexHull& hull, const Eigen::Vector3d& p);

/// Euclidean distance from p to the hull [m], 0 inside. Exact. Without faces, or for a point that
/// is not finite, as planeDistance().
double distance(const ConvexHull& hull, const Eigen::Vector3d& p);

/// The hull's surface as a mesh.
TriangleMesh surface(const ConvexHull& hull);

}  // namespace collision_hulls
