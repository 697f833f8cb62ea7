// Axes of a mesh's own: decomposition is quicker, and the number of hulls steadier, if flat faces are axis-aligned.
#pragma once

#include <Eigen/Core>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The rotation from the mesh's frame into one in which much more of its surface is axis-aligned; the identity if there is no such frame,
/// as for parts that are aligned already and for round ones. Deterministic.
Eigen::Matrix3d ownAxes(const TriangleMesh& mesh);

/// The rotation into a frame that turns with the mesh: along its flat faces, or along its principal axes if it has few. Up to rounding, a
/// turned copy lies in its frame as the original does in its own, or as a symmetry of the shape leaves it; but for surfaces of revolution,
/// where it may be turned about their axis. Deterministic.
Eigen::Matrix3d steadyAxes(const TriangleMesh& mesh);

}  // namespace collision_hulls
