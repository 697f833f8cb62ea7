// For the library alone: a hull tree for primitives, which are measured themselves.
#pragma once

#include "collision_hulls/decompose/certified.h"

namespace collision_hulls {

/// The tree of hullTree() in less time: its bounds are no more than the diagonals of the hulls' boxes.
HullTree hullTreeWithoutProof(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control);

}  // namespace collision_hulls
