// Queries FCL in any one of its settings and compares the answer with the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/stability/fcl_pairs.h"

namespace collision_hulls {

/// One setting of a query. `tolerance` is FCL's own, absolute [m]; 0 if the query has none.
struct FclSetting {
  enum class Query {
    kDistance,        ///< distance(); 0 or -1 for overlap
    kSignedDistance,  ///< distance() with enable_signed_distance; negative for overlap
    kCollide,         ///< collide(); yes or no
    kValidator        ///< as validate() queries, in its frame: see fcl_queries.h
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
    kMinusOne,  ///< -1 for overlapping bodies: correct, but not a distance
    kOff,
    kNan,
    kException
  } outcome = Outcome::kExact;
  double error = 0;  ///< for exact and off: in sizes of the larger body; for a wrong collide(): how clear the case was
};
const char* name(FclTrial::Outcome outcome);  ///< "exact", "minus_one", "off", "nan", "exception"

/// Queries FCL once. The truth refers to solids, which is more than a BVH represents. FCL may abort the process or never return.
FclTrial tryFcl(const FclSetting& setting, const BodyPair& pair);

}  // namespace collision_hulls
