// Candidate planes for splitting a piece that protrudes too far. A *reflex edge* is one where the
// surface bends inward, so that the inside takes more than half a turn about it; an *intruder* is a
// point of the piece's hull outside the solid by more than the tolerance.
#pragma once

#include <vector>

#include "decompose/surface_piece.h"
#include "measure/outside_distance.h"

namespace collision_hulls {

/// Candidates, the most promising first: at reflex edges, where the surface bends inward, the
/// planes of both faces and of the bisector (similar planes are joined; long, sharp edges come
/// first); then planes through a few of the intruders, normal to the axes, and across and along the
/// line to the solid's nearest point. Deterministic.
std::vector<HalfSpace> splitPlanes(const SurfacePiece& piece, const std::vector<OutsideDistance::Intruder>& intruders, const Solid& solid,
                                   double tolerance);

}  // namespace collision_hulls
