// A mesh stood upright: decomposition is quicker, and the number of hulls steadier, where flat faces lie along the axes.
#pragma once

#include <Eigen/Core>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The rotation from the mesh's frame into one along whose axes much more of its surface lies flat; the identity where there is none,
/// as for parts that are upright already, and for round ones. Deterministic.
Eigen::Matrix3d ownAxes(const TriangleMesh& mesh);

}  // namespace collision_hulls
