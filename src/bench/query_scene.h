// Where queries are asked: a cluttered table and shelf about a robot or a part, and the states that it is put in. All seeded.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// What a subject reaches, about the root of a robot or about a part.
struct Reach {
  double radius = 0;         ///< [m]
  double low = 0, high = 0;  ///< [m] heights
};

/// A table before the subject and a shelf behind it, with boxes and cylinders (prisms of 24 sides) on both.
std::vector<ConvexHull> clutteredScene(const Reach& reach, std::uint64_t seed);

/// Poses anywhere about that scene, turned anyhow.
std::vector<Eigen::Isometry3d> freePoses(const Reach& reach, std::size_t count, std::uint64_t seed);

}  // namespace collision_hulls
