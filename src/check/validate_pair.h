// The check of one element: original against hulls, query by query.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check/pair_model.h"
#include "collision_hulls/check/validate.h"

namespace collision_hulls {

/// What the queries of one pair gave, before they are summed up.
struct PairResult {
  Validation counts;                     ///< all but the times
  std::vector<double> mesh_us, hull_us;  ///< [us] of each probe that both were asked about
};

constexpr std::size_t kMostRemarks = 20;

/// Why a pair cannot be checked, as the end of a sentence; empty if it can. Throws kIndexOutOfRange.
std::string fault(const ValidationPair& pair);

/// Runs the queries of a pair without fault whose original has triangles; `index` and the seed choose the poses. `boxes`: see boxShapes().
/// The result of several queries at a time, in their order. Deterministic but for the times.
std::vector<PairResult> validatePair(const ValidationPair& pair, std::size_t index, const std::vector<ProbeShape>& boxes,
                                     const std::vector<Neighbour>& neighbours, const ValidationOptions& options, const RunControl& control);

}  // namespace collision_hulls
