// Bottom up: merges groups (surface_groups.h), cheapest first, while their common hull fits, i.e.
// protrudes no further than the tolerance. Two groups are *apart* if their common hull is known not
// to fit.
#pragma once

#include <cstdint>

#include "decompose/certified/surface_groups.h"

namespace collision_hulls {

/// The cost of a merge, in terms of the mean widths of the union u and of both parts a and b.
struct MergeCost {
  enum Kind { kSize, kGrowth, kMeanGrowth, kSquares };
  Kind kind = kSize;  ///< u; u - max(a, b); u - (a + b) / 2; u^2 - a^2 - b^2
  double noise = 0;   ///< u is perturbed by a random share of up to half of this, either way
  std::uint64_t seed = 0;
};

/// Whether merges are accepted provisionally, to be proven afterwards, or proven before they are
/// made.
enum class Proof { kLater, kAtOnce };

/// Merges greedily. Deterministic.
Cover merged(Cover cover, SurfaceGroups& groups, const MergeCost& cost, Proof proof);

/// Merges greedily with everything proven. For few groups it takes the kind of cost that
/// provisionally leaves fewest; for many, kSquares, which did best when the kinds were compared.
/// Where a deadline ends it, with the merges proven by then.
Cover mergedBest(const Cover& cover, SurfaceGroups& groups);

}  // namespace collision_hulls
