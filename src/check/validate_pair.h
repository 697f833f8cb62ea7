// Checks one element: the original against its hulls, query by query.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check/pair_model.h"
#include "collision_hulls/check/validate.h"

namespace collision_hulls {

/// The results of a pair's queries, before they are summed up.
struct PairResult {
  Validation counts;                     ///< everything except times
  std::vector<double> mesh_us, hull_us;  ///< [us] per probe that was queried against both
};

constexpr std::size_t kMostRemarks = 20;

/// Why a pair cannot be checked, worded to end a sentence; empty if it can. Throws kIndexOutOfRange.
std::string fault(const ValidationPair& pair);

/// Runs the queries of a sound pair whose original has triangles; `index` and the seed determine the poses. `boxes`: see boxShapes(). Each
/// result covers several queries, in order. Takes the original, which may be large, from the pair. Deterministic except for the times.
std::vector<PairResult> validatePair(ValidationPair& pair, std::size_t index, const std::vector<ProbeShape>& boxes,
                                     const std::vector<Neighbour>& neighbours, const ValidationOptions& options, const RunControl& control);

}  // namespace collision_hulls
