// How good a cut is: reckoned on a simplified piece, since hundreds of planes are tried for each cut.
#pragma once

#include <utility>
#include <vector>

#include "check/outside_distance.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// What counts beside the intruders that a cut leaves in the hulls of its sides, all of which together weigh 1.
struct ScoreWeights {
  double volume_gain = 0.5;   ///< the share of the hull's volume that neither side's hull holds
  double finished_share = 0;  ///< the share of it in a side that holds no intruder
  double finished = 0;        ///< whether there is such a side
};

class PlaneScore {
 public:
  /// `piece` is simplified to `vertices` at most; `volume` [m^3] is that of its hull.
  PlaneScore(const SurfacePiece& piece, std::size_t vertices, std::vector<OutsideDistance::Intruder> intruders, double volume,
             const ScoreWeights& weights);

  /// The planes, best first, at most `most`; those that divide nothing are left out.
  std::vector<HalfSpace> best(const std::vector<HalfSpace>& planes, std::size_t most) const;

  const SurfacePiece& piece() const { return piece_; }

 private:
  double operator()(const HalfSpace& plane) const;

  SurfacePiece piece_;
  std::vector<std::pair<int, int>> edges_;
  std::vector<OutsideDistance::Intruder> intruders_;
  double weight_ = 0, volume_, on_plane_ = 0;
  ScoreWeights weights_;
};

}  // namespace collision_hulls
