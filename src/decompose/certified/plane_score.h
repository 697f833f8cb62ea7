// How good a split is: estimated on a simplified piece, because hundreds of planes are tried for
// each split.
//
// Terms: the *sides* of a plane are the parts of a piece below and above it. An *intruder* is a
// point of the piece's hull outside the solid by more than the tolerance; a split should leave few
// of them in its sides' hulls. A side is *finished* if its hull holds none.
#pragma once

#include <utility>
#include <vector>

#include "decompose/surface_piece.h"
#include "measure/outside_distance.h"

namespace collision_hulls {

/// What counts besides the intruders that a split leaves in its sides' hulls; all intruders
/// together weigh 1.
struct ScoreWeights {
  double volume_gain = 0.5;   ///< for the share of the hull's volume that neither side's hull contains
  double finished_share = 0;  ///< for the share of it in a side without intruders
  double finished = 0;        ///< for having such a side at all
};

class PlaneScore {
 public:
  /// `piece` is simplified to at most `vertices`; `volume` [m^3] is that of its hull.
  PlaneScore(const SurfacePiece& piece, std::size_t vertices, std::vector<OutsideDistance::Intruder> intruders, double volume,
             const ScoreWeights& weights, const RunControl& control);

  /// At most `most` of the planes, best first, without those that divide nothing.
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
