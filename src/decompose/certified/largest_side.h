// A split that finishes one side: as much of a piece as one hull can take, from the outside inward.
// *Below* a plane is where its normal does not point.
#pragma once

#include <optional>

#include "decompose/certified/protrusion_oracle.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// Of the planes normal to a few directions, the one below which the most area lies while its hull
/// very likely stays within the tolerance; nullopt if that area is small or nearly all of the
/// piece, and for large pieces.
std::optional<HalfSpace> largestSide(const SurfacePiece& piece, ProtrusionOracle& oracle);

}  // namespace collision_hulls
