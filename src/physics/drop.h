// Drops a body on a table and pushes it: does its collision model hold it where the original would stand?
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "physics/engine.h"

namespace collision_hulls {

/// A body of 1 kg with its frame at the centre of mass: the hull of the original, which tells how it would stand, and its collision model.
struct DropBody {
  ConvexHull original;
  std::vector<std::vector<Eigen::Vector3d>> hulls;  ///< Way::kConvex
  std::vector<std::string> files;                   ///< Way::kMesh
};

/// D is the diagonal of the original. Angles in radians.
struct DropResult {
  /// ok; moving: not at rest when it was pushed; tipped: fell over onto another face; sunk: the original is more than 1 % of D deep in the
  /// table; fell: through or off the table; unstable: gained energy, or its state became non-finite. The worst that applies.
  std::string outcome = "ok";
  double tilt = 0;            ///< between the face that it should stand on and the table
  double height = 0;          ///< [D] gap between table and original at rest; negative: the original is in the table
  double penetration = 0;     ///< [D] greatest depth of the original in the table
  double drift = 0;           ///< [D] creep in the half second before the push
  double slide = 0;           ///< [D] distance slid after the push; friction alone would stop it after kSlide
  double energy = 0;          ///< [m g D] largest rise
  double settle_seconds = 0;  ///< time until it was at rest
  double step_us = 0;         ///< [us] median time of an engine step, over the second half of the settling
  std::size_t contacts = 0;   ///< at rest
};

constexpr double kBodySize = 0.3;  // [m] D
constexpr double kSlide = 0.1;     // [D]

/// Drops the body from just above the table, slightly tilted out of `pose`, waits, and pushes it sideways.
DropResult drop(const DropBody& body, Way way, const RestingPose& pose);

}  // namespace collision_hulls
