// The scene of the queries, a cluttered table and shelf around a robot or a part, and poses to query. All seeded.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// How far a subject reaches, around a robot's root or around a part.
struct Surroundings {
  double radius = 0;         ///< [m]
  double low = 0, high = 0;  ///< [m] heights
};

/// A table in front of the subject and a shelf behind it, with boxes and cylinders (prisms of 24 sides) on both.
std::vector<ConvexHull> clutteredScene(const Surroundings& reach, std::uint64_t seed);

/// Random poses throughout that scene, in random orientations.
std::vector<Eigen::Isometry3d> freePoses(const Surroundings& reach, std::size_t count, std::uint64_t seed);

}  // namespace collision_hulls
