// Boxes, spheres and cylinders about hulls, as a robot description can hold them.
//
// What FCL 0.7 takes for a pair that is near and apart, against a box, a hull of 64 vertices and a mesh of 1,000 triangles: sphere 0.1, 0.3
// and 14 us; box 0.1, 0.3, 0.4; cylinder 0.2, 0.3, 3; hull of 16 to 64 vertices 0.3, 0.3, 6 to 8; the same hull as a mesh, which MoveIt
// makes of its file, 1.5, 2.5, 2. A capsule, which a description has to put together of a cylinder and two spheres, takes the three's sum:
// more than the hull, so that there are none here.
#pragma once

#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// A primitive that holds all of a hull, in the hull's frame, a little larger than it must be so that rounding takes nothing away: also
/// where a description is read that has its numbers, and its origin in roll, pitch and yaw. Deterministic.
///
/// The sphere is the smallest of all; the box that of orientedBox(); the cylinder the smallest about axes along that box, the principal
/// axes and the hull's longest edges, the best of them turned until no turn makes it smaller. Throws kInternal if a vertex is outside.
GeometryElement enclosingPrimitive(GeometryElement::Kind kind, const ConvexHull& hull);

/// [m^3]
double volume(const GeometryElement& primitive);

/// The point of a primitive that is nearest to p; p itself inside.
Eigen::Vector3d nearestPoint(const GeometryElement& primitive, const Eigen::Vector3d& p);

/// A polyhedron about a primitive, in the frame that its origin is given in: a box itself, round ones as scene.h has them.
ConvexHull hullAbout(const GeometryElement& primitive);

}  // namespace collision_hulls
