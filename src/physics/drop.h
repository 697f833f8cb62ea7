// A body dropped on a table and pushed: does its collision model hold it where the original would stand?
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "physics/engine.h"

namespace collision_hulls {

/// A body of 1 kg, its frame at the centre of mass; its original's hull, which says where it would stand, and its collision model.
struct DropBody {
  ConvexHull original;
  std::vector<std::vector<Eigen::Vector3d>> hulls;  ///< Way::kConvex
  std::vector<std::string> files;                   ///< Way::kMesh
};

/// D is the diagonal of the original. Angles in radians.
struct DropResult {
  /// ok; moving: not at rest when it was pushed; tipped: over, to another face; sunk: the original stands in the table by more than 1 % of
  /// D; fell: through or off the table; unstable: it gained energy or was lost to numbers that are none. The worst that holds.
  std::string outcome = "ok";
  double tilt = 0;            ///< between the face that it should stand on and the table
  double height = 0;          ///< [D] gap between table and original at rest; negative: the original is in the table
  double penetration = 0;     ///< [D] deepest that the original was in the table
  double drift = 0;           ///< [D] creep in the half second before the push
  double slide = 0;           ///< [D] way after the push, which friction ends after kSlide
  double energy = 0;          ///< [m g D] largest rise
  double settle_seconds = 0;  ///< until it was at rest
  double step_us = 0;         ///< [us] median of a step of the engine while it stands
  std::size_t contacts = 0;   ///< at rest
};

constexpr double kBodySize = 0.3;  // [m] D
constexpr double kSlide = 0.1;     // [D]

/// Lets the body fall from a little above the table, a little tilted out of `pose`, waits, and pushes it sideways.
DropResult drop(const DropBody& body, Way way, const RestingPose& pose);

}  // namespace collision_hulls
