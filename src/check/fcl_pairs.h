// Pairs of convex bodies of the kinds that collision queries meet, with the truth about them.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Bodies are about a metre in size, of 14 vertices, shaped and turned at random, unless said otherwise.
enum class PairKind {
  kFar,         ///< one to three sizes apart
  kNear,        ///< a nanometre to a centimetre apart, a corner over a face
  kTouching,    ///< a corner on a face; every other time boxes, one on the other
  kDeep,        ///< middles 0.3 sizes apart
  kContained,   ///< the second wholly within the first, a tenth of its size
  kFlat,        ///< the first is a plate 1e-6 of its size thick; about 1 cm apart
  kNeedle,      ///< both are rods, a thousand times as long as thick; about 1 cm apart
  kMillimetre,  ///< as kNear or, every other time, kDeep, all a thousand times smaller
  kIdentical,   ///< the same body at the same place
  kUnequal      ///< 10 m and 1 cm; as kNear
};
const char* name(PairKind kind);  ///< "far", ..., "millimetre", "identical", "1cm_10m"
const std::vector<PairKind>& allPairKinds();

struct BodyPair {
  ConvexHull first, second;                                ///< each in its own frame
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of the second in the first one's frame
  double size = 1;                                         ///< [m] of the larger one
};

/// The same seed and number give the same pair everywhere.
BodyPair bodyPair(PairKind kind, std::uint64_t seed, std::uint64_t number);

/// [m] The distance between the two as solids; where they overlap, the negative length of the shortest move that parts them. Exact to
/// rounding: brute force.
double signedDistance(const BodyPair& pair);

}  // namespace collision_hulls
