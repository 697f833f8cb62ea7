// Fewer hulls: groups that lie near each other are dissolved and merged anew, again and again, and what is no worse is kept.
#pragma once

#include <cstdint>

#include "decompose/surface_groups.h"

namespace collision_hulls {

struct SearchOptions {
  long evaluations = 0;  ///< hulls that may be built and asked about: not seconds, so that the result does not depend on the machine
  std::uint64_t seed = 1;
};

/// A cover by no more groups than `cover`, proven if that is. Deterministic. Calls `progress` with the share of evaluations made.
Cover improved(Cover cover, SurfaceGroups& groups, const SearchOptions& options, const std::function<void(double)>& progress);

}  // namespace collision_hulls
