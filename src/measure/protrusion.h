// Settings of the search for protrusion().
#pragma once

#include <algorithm>
#include <cstddef>

#include "collision_hulls/measure/measures.h"

namespace collision_hulls {

struct ProtrusionSearch {
  double gap = 0;    ///< [m] as in measures.h
  double share = 0;  ///< of the protrusion: the gap where that is more than `gap`. Above 0, a bound of two gaps is also enough.
  /// Cells that the search for summits may visit beyond its usual number, for all hulls together. It may need them along a narrow gap of
  /// constant width, as between a shaft and its bore, where nearly every point is a summit.
  std::size_t spare_visits = 0;
  double floor = 0;  ///< [m] distances up to this do not matter, and are not found
};
/// Of hulls that check() lets pass.
Protrusion protrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, const ProtrusionSearch& search, const RunControl& control);

/// The larger of two bounds, and the further of two places: `worst` becomes what is known of both. For Protrusion and what has its `bound`,
/// `found` and place.
template <typename Measured>
void takeWorse(Measured& worst, const Measured& other) {
  const double bound = std::max({worst.bound, other.bound, other.found});
  if (other.found > worst.found) worst = other;
  worst.bound = bound;
}

}  // namespace collision_hulls
