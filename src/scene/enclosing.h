// Boxes, spheres and cylinders about hulls, as a robot description can hold them.
//
// There are no capsules: a description has to put one together of a cylinder and two spheres, which FCL asks one by one, and that takes
// longer than the hull.
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
