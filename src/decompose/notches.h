// Where a surface is not convex: its reflex edges, and how far they lie beneath the hull.
#pragma once

#include <Eigen/Geometry>

#include "collision_hulls/control.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// The notch of highest concavity.
struct Notch {
  double concavity = 0;                                ///< [m] from `point` to its bridge; 0: there is no notch
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     ///< an end or the middle of a reflex edge
  Eigen::Vector3d bisector = Eigen::Vector3d::Zero();  ///< unit normal of the plane that contains the edge and halves the angle there
};

/// Of equal notches the first is taken. Edges of more than two triangles count where two consecutive ones, which must run along the
/// edge in opposite directions, make them reflex. Deterministic. Throws kCancelled.
Notch deepestNotch(const SurfacePiece& piece, const ConvexHull& hull, bool two_sided, const RunControl& control);

}  // namespace collision_hulls
