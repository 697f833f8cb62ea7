// Boxes, spheres and cylinders that enclose hulls, as a robot description can express them.
//
// There are no capsules: URDF has to compose one from a cylinder and two spheres, which FCL checks one by one, and that takes longer than
// checking the hull.
#pragma once

#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// A primitive that encloses a hull, in the hull's frame. It is a little larger than necessary, so that it still encloses the hull after
/// rounding, and after its numbers were written to a robot description, with the origin as roll, pitch and yaw, and read back.
/// Deterministic.
///
/// The sphere is the smallest possible; the box is that of orientedBox(); the cylinder is the smallest one along the box's axes, the
/// principal axes and the hull's longest edges, with the best axis then turned until no turn makes the cylinder smaller. Throws kInternal
/// if a vertex is outside.
GeometryElement enclosingPrimitive(GeometryElement::Kind kind, const ConvexHull& hull);

/// [m^3]
double volume(const GeometryElement& primitive);

/// The point of a primitive that is nearest to p; p itself if p is inside.
Eigen::Vector3d nearestPoint(const GeometryElement& primitive, const Eigen::Vector3d& p);

/// A polyhedron around a primitive, in the frame in which its origin is given: a box is its own; round ones are circumscribed as in
/// scene.h.
ConvexHull hullAbout(const GeometryElement& primitive);

}  // namespace collision_hulls
