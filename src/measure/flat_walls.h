// Flat walls that the inside lies on both sides of, as between boxes that touch: surface, and nothing outside.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Whether some triangles lie in one plane and face opposite ways. Where rounding hides that, it answers no; that costs bounds, not proofs.
bool someFaceEachOther(const TriangleMesh& mesh, const RunControl& control);

/// [m] Bounds on the distance to what is inside or surface; infinite where nothing is proved.
struct AmongFlatWalls {
  double any = std::numeric_limits<double>::infinity();  ///< of any point
  double summit =
      std::numeric_limits<double>::infinity();  ///< of a local maximum whose distance, as a radius, leads nowhere out of the ball
};

/// Looks at the ball of this radius [m] about p (lemma 11 of doc/certified.md). `closed` is a closed surface, `surface` all surface. Where
/// these lie in three planes at most in the ball, and nothing is outside but on one side of one of them, the bounds are a few millionths of
/// the extent at most.
AmongFlatWalls amongFlatWalls(const TriangleBvh& closed, const TriangleBvh& surface, const Eigen::Vector3d& p, double radius);

}  // namespace collision_hulls
