// What of a surface no triangle with an area holds.
#pragma once

#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// Adds a segment as a triangle with two equal corners, a point as one with three, so that it counts as surface.
void addSegment(TriangleMesh& mesh, const Segment& segment);

/// The mesh and its loose segments as one surface.
TriangleMesh withLoose(const RepairedMesh& mesh);

Eigen::AlignedBox3d boundingBox(const RepairedMesh& mesh);

/// A corner of each component, and one of each loose segment.
std::vector<Eigen::Vector3d> pointsOfComponents(const RepairedMesh& mesh);

}  // namespace collision_hulls
