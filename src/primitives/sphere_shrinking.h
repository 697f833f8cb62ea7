// Spheres that cover a surface, each as little protruding as the others let it be.
#pragma once

#include <vector>

#include "collision_hulls/primitives/spheres.h"
#include "primitives/tolerable_space.h"

namespace collision_hulls {

/// The spheres cover the mesh; so do those that are returned. None is added, and none has a larger bound:
/// each moves and changes its radius so that it holds what no other holds, and protrudes less. Those that hold nothing of their own go.
/// Deterministic.
std::vector<Sphere> shrunk(std::vector<Sphere> spheres, const TriangleMesh& mesh, const TolerableSpace& space, const RunControl& control);

}  // namespace collision_hulls
