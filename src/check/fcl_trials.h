// FCL asked in one of the ways that it can be asked, and its answer held against the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/fcl_pairs.h"

namespace collision_hulls {

/// A way of asking. `tolerance` is FCL's own, absolute [m]; 0 where the query has none.
struct FclSetting {
  enum class Query {
    kDistance,        ///< distance(), 0 or -1 for overlap
    kSignedDistance,  ///< distance() with enable_signed_distance, negative for overlap
    kCollide,         ///< collide(), whether or not
    kValidator        ///< the queries of validate(), in its frame: see fcl_queries.h
  };
  enum class Bodies { kConvexConvex, kBvhConvex, kBvhBvh };
  enum class Solver { kLibccd, kIndep, kNone };
  Query query = Query::kDistance;
  Bodies bodies = Bodies::kConvexConvex;
  Solver solver = Solver::kLibccd;
  double tolerance = 0;
};
std::string queryName(const FclSetting& setting);  ///< "distance Convex-Convex", "validator BVH-BVH", ...
const char* name(FclSetting::Solver solver);       ///< "libccd", "indep", "none"
const std::vector<FclSetting>& fclSettings();

struct FclTrial {
  enum class Outcome {
    kExact,     ///< within kFclTolerance of the truth, in sizes of the larger body
    kMinusOne,  ///< -1 for bodies that overlap: right, but no distance
    kOff,
    kNan,
    kException
  } outcome = Outcome::kExact;
  double error = 0;  ///< of exact and off, in sizes of the larger body; of a wrong collide(), how clear the case was
};
const char* name(FclTrial::Outcome outcome);  ///< "exact", "minus_one", "off", "nan", "exception"

/// Asks FCL once. The truth is that of solids, which is more than a BVH knows. May abort the process, or not end: FCL's doing.
FclTrial tryFcl(const FclSetting& setting, const BodyPair& pair);

}  // namespace collision_hulls
