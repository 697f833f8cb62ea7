// Points of a surface that no triangle holds.
#pragma once

#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// Adds a point as a triangle of three equal corners, so that it counts as surface.
void addPoint(TriangleMesh& mesh, const Eigen::Vector3d& p);

/// The mesh and its loose points as one surface.
TriangleMesh withLoosePoints(const RepairedMesh& mesh);

/// A corner of each component, and the loose points.
std::vector<Eigen::Vector3d> pointsOfComponents(const RepairedMesh& mesh);

}  // namespace collision_hulls
