// The surface that is split: as it lies in space, whatever the mesh that it comes from says besides.
#pragma once

#include "decompose/surface_piece.h"

namespace collision_hulls {

/// The same surface to within `flat` [m], with vertices and triangles in an order that depends on their places alone, and without vertices
/// that its shape does without: those inside flat faces, along straight edges, and at the tips of triangles that have hardly any height.
SurfacePiece tidied(const SurfacePiece& surface, double flat, const RunControl& control = {});

}  // namespace collision_hulls
