// A cut that leaves one side done: the most of a piece that one hull can take, from outside inward.
#pragma once

#include <optional>

#include "decompose/protrusion_oracle.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// The plane beneath which the most of the piece's area lies whose hull most likely fits, of planes across a few directions; nullopt
/// where it is little or next to all, and for large pieces.
std::optional<HalfSpace> largestSide(const SurfacePiece& piece, ProtrusionOracle& oracle);

}  // namespace collision_hulls
