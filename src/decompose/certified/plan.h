// How hard a decomposition tries: the ways to split a surface, in their order, and the length of each search.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "collision_hulls/decompose/decompose.h"
#include "decompose/certified/plane_score.h"

namespace collision_hulls {

/// One way to split.
struct Way {
  static constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

  ScoreWeights weights;
  double leaf_share = 0;         ///< of the tolerance, that leaves may use
  std::size_t few = kAnyNumber;  ///< tried only if the ways before it leave no more hulls than this
  bool largest_side_first = false;
};

struct SearchPlan {
  std::vector<Way> ways;       ///< at least one
  std::size_t elements = 0;    ///< pieces that leaves are divided into for the search; 0: leaves are not divided
  long first_evaluations = 0;  ///< of hulls, in the search after each way of splitting,
  long evaluations = 0;        ///< and in the final search on the best cover
  std::size_t most_leaves;     ///< of a part that is split on its own,
  std::size_t most_in_all;     ///< and of the mesh
};

SearchPlan planFor(Effort effort);

}  // namespace collision_hulls
