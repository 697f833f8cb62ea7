// Pairs of convex bodies of the kinds that occur in collision queries, together with their true distance.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Unless noted otherwise, bodies are about a metre in size, with 14 vertices, random in shape and orientation.
enum class PairKind {
  kFar,         ///< one to three sizes apart
  kNear,        ///< a nanometre to a centimetre apart, a corner over a face
  kTouching,    ///< a corner on a face; every other pair: two boxes, one on the other
  kDeep,        ///< centres 0.3 sizes apart
  kContained,   ///< the second inside the first and a tenth of its size
  kFlat,        ///< the first is a plate, as thick as 1e-6 of its size; about 1 cm apart
  kNeedle,      ///< both are rods, a thousand times longer than thick; about 1 cm apart
  kMillimetre,  ///< like kNear or, every other pair, kDeep, but a thousand times smaller
  kIdentical,   ///< the same body in the same place
  kUnequal      ///< 10 m and 1 cm in size; like kNear
};
const char* name(PairKind kind);  ///< "far", ..., "millimetre", "identical", "1cm_10m"
const std::vector<PairKind>& allPairKinds();

struct BodyPair {
  ConvexHull first, second;                                ///< each in its own frame
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< the second one's in the first one's frame
  double size = 1;                                         ///< [m] size of the larger one
};

/// The same seed and number give the same pair on every platform.
BodyPair bodyPair(PairKind kind, std::uint64_t seed, std::uint64_t number);

/// [m] The distance between the two solids; if they overlap, minus the length of the shortest move that separates them. Exact up to
/// rounding, by brute force.
double signedDistance(const BodyPair& pair);

}  // namespace collision_hulls
