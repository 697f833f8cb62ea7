// Planes along which a piece that protrudes too far may be cut.
#pragma once

#include <vector>

#include "check/outside_distance.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// Candidates, best guesses first: the planes of both faces and of the bisector at reflex edges, where the surface turns
/// inward (like ones are joined; long, sharp edges first), then planes through a few of the intruders, along the axes and across
/// and along the way to the solid's nearest point. Deterministic.
std::vector<HalfSpace> cutPlanes(const SurfacePiece& piece, const std::vector<OutsideDistance::Intruder>& intruders, const Solid& solid,
                                 double tolerance);

}  // namespace collision_hulls
