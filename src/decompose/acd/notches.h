// Where a surface is not convex: its reflex edges and their depth below the hull.
#pragma once

#include <Eigen/Geometry>

#include "collision_hulls/control.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// The notch of highest concavity.
struct Notch {
  double concavity = 0;                                ///< [m] distance from `point` to its bridge; 0: there is no notch
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     ///< an end or the midpoint of a reflex edge
  Eigen::Vector3d bisector = Eigen::Vector3d::Zero();  ///< unit normal of the plane that contains
                                                       ///< the edge and bisects the angle there
};

/// The deepest notch, the first one on a tie. At edges of more than two triangles, two consecutive
/// triangles count if they run along the edge in opposite directions and form a reflex angle.
/// Deterministic. Throws kCancelled.
Notch deepestNotch(const SurfacePiece& piece, const ConvexHull& hull, bool two_sided, const RunControl& control);

}  // namespace collision_hulls
