// Boxes, spheres and cylinders that enclose hulls, as a robot description can express them.
//
// There are no capsules: URDF has to compose one from a cylinder and two spheres, which FCL checks one by one, and that takes longer than
// checking the hull.
#pragma once

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/primitives/primitive.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// Throws kInternal for a capsule.
GeometryElement elementOf(const Primitive& primitive);

/// As for a Primitive (primitives/primitive.h).
GeometryElement enclosingPrimitive(GeometryElement::Kind kind, const ConvexHull& hull);

/// [m^3]
double volume(const GeometryElement& primitive);

/// The point of a primitive that is nearest to p; p itself if p is inside.
Eigen::Vector3d nearestPoint(const GeometryElement& primitive, const Eigen::Vector3d& p);

/// A polyhedron around a primitive, in the frame in which its origin is given: a box is its own; round ones are circumscribed as in
/// scene.h.
ConvexHull hullAbout(const GeometryElement& primitive);

}  // namespace collision_hulls
