// Boxes, spheres, cylinders and capsules: the shapes that collision checkers have built in.
//
// For example:
//
//     const Primitive ball = enclosingPrimitive(PrimitiveKind::kSphere, hull);
//     const double radius = ball.size.x();        // [m]
//     const double away = distance(ball, {1, 1, 1});  // [m] 0 inside
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

enum class PrimitiveKind {
  kSphere,
  kCapsule,  ///< everything within a radius of a segment
  kBox,
  kCylinder
};
const char* name(PrimitiveKind kind);  ///< "sphere", "capsule", "box", "cylinder"
std::optional<PrimitiveKind> primitiveKindNamed(const std::string& name);
const std::vector<PrimitiveKind>& allPrimitiveKinds();

/// A closed convex body about the origin of its frame; the axis of a cylinder or capsule is z.
struct Primitive {
  PrimitiveKind kind = PrimitiveKind::kBox;
  /// [m] box: sides; sphere: radius, -, -; cylinder: radius, length, -; capsule: radius, length of
  /// the segment (the whole is longer by two radii), -
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of its frame in the mesh's
};

double volume(const Primitive& primitive);  ///< [m^3]

/// [m] The point of a primitive that is nearest to p; p itself if p is inside.
Eigen::Vector3d nearestPoint(const Primitive& primitive, const Eigen::Vector3d& p);

/// [m] From p to the primitive, 0 inside.
double distance(const Primitive& primitive, const Eigen::Vector3d& p);

/// The largest direction . x over the points x of the primitive; in metres for a direction of unit
/// length.
double support(const Primitive& primitive, const Eigen::Vector3d& direction);

/// A polyhedron that contains the primitive and whose points are no further than about `excess`
/// [m], > 0, from it; a box is its own. An excess below a thousandth of the radius may not be
/// reached, as that would take too many faces. Throws kInternal if it does not contain the
/// primitive.
ConvexHull hullAround(const Primitive& primitive, double excess);

/// A primitive that encloses a hull. It is larger than necessary by 1e-7 of the size and the
/// distance from the origin, so that it still encloses the hull after its numbers were written to a
/// robot description, with the pose as roll, pitch and yaw, and read back. Deterministic.
///
/// The sphere is the smallest one. The box is that of orientedBox(). Cylinders and capsules are the
/// smallest along the box's axes, the principal axes and the hull's longest edges, with the best
/// axis then turned until no turn makes the body smaller. Throws kEmptyMesh for a hull without
/// vertices, kInternal if a vertex is outside, and kCancelled.
Primitive enclosingPrimitive(PrimitiveKind kind, const ConvexHull& hull,
                             const RunControl& control = {});

}  // namespace collision_hulls
