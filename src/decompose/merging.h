// Bottom up: groups merged, cheapest first, while their common hull stays within the tolerance.
#pragma once

#include <cstdint>

#include "decompose/surface_groups.h"

namespace collision_hulls {

/// What a merge costs, by the mean widths of the union u and of both parts a and b.
struct MergeCost {
  enum Kind { kSize, kGrowth, kMeanGrowth, kSquares };
  Kind kind = kSize;  ///< u; u - max(a, b); u - (a + b) / 2; u^2 - a^2 - b^2
  double noise = 0;   ///< random share of u that is added or taken away
  std::uint64_t seed = 0;
};

/// Whether a merge is taken on trust, to be proven afterwards, or proven before it is made.
enum class Proof { kLater, kAtOnce };

/// What greedy merging leaves. Deterministic.
Cover merged(Cover cover, SurfaceGroups& groups, const MergeCost& cost, Proof proof);

/// All of them proven: of few by the kind of cost that leaves fewest on trust, of more by kSquares, which was best where kinds were
/// compared.
Cover mergedBest(const Cover& cover, SurfaceGroups& groups);

}  // namespace collision_hulls
