// Spheres and cylinders of a description, exactly where that is possible and as polyhedra within a known error where it is not.
#pragma once

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// Whether an element is a sphere or a cylinder.
bool isRound(const GeometryElement& element);

/// [m] From p to the element, 0 inside. Exact, for any primitive.
double distance(const GeometryElement& primitive, const Eigen::Vector3d& p);

/// A polyhedron and how far it may be from the shape that it stands for.
struct Approximation {
  ConvexHull hull;
  double error = 0;  ///< [m] no point of either surface is further than this from the other body's surface
};

/// With its vertices on the surface of a sphere or cylinder, in the frame in which the element's origin is given.
Approximation inscribed(const GeometryElement& round);

/// Around a sphere or cylinder.
Approximation circumscribed(const GeometryElement& round);

/// Whether a hull holds all of a sphere or cylinder, exactly but for rounding.
bool holds(const ConvexHull& hull, const GeometryElement& round);

/// [m] No point of either primitive is further than this from the other: 0 for equal bodies up to rounding, infinity for those of two
/// kinds. Close only for bodies that are nearly alike. Both in one frame.
double apartAtMost(const GeometryElement& a, const GeometryElement& b);

}  // namespace collision_hulls
