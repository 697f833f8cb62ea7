// Fewer hulls by local search: dissolves neighbouring groups and merges them again, and keeps what
// is no worse. One *evaluation* is one hull built and put to the oracle; answers that are
// remembered cost none.
#pragma once

#include <cstdint>

#include "decompose/certified/surface_groups.h"

namespace collision_hulls {

struct SearchOptions {
  long evaluations = 0;  ///< hulls that may be built and evaluated: counted, not timed, so that the result does not depend on the machine
  std::uint64_t seed = 1;
  std::size_t enough = 0;  ///< groups, than which no cover is known to have fewer: the search ends with as many
};

/// A cover with no more groups than `cover`, proven if `cover` is. Deterministic. Calls `progress`
/// with the share of evaluations used. A deadline ends it with what it has.
Cover improved(Cover cover, SurfaceGroups& groups, const SearchOptions& options, const std::function<void(double)>& progress);

}  // namespace collision_hulls
