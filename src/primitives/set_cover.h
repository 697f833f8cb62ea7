// Few sets that cover everything.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Elements 0 .. elements - 1, and sets of them; each element is in some set.
struct SetSystem {
  std::size_t elements = 0;
  std::vector<std::vector<int>> sets;  ///< the elements of each
};

/// Sets that cover all elements, in ascending order: those of `start` that stay, completed greedily, then improved by a local search that
/// takes about `work` steps, each to an element of a set. Deterministic.
std::vector<int> fewSets(const SetSystem& system, const std::vector<int>& start, std::size_t work, const RunControl& control);

}  // namespace collision_hulls
