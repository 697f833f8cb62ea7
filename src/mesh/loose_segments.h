// The parts of a surface that no triangle with an area contains.
#pragma once

#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// Adds a segment as a triangle with two equal corners (a point: three), and so makes it part of the surface.
void addSegment(TriangleMesh& mesh, const Segment& segment);

/// The mesh and its loose segments as one surface.
TriangleMesh withLoose(const RepairedMesh& mesh);

Eigen::AlignedBox3d boundingBox(const RepairedMesh& mesh);

/// One corner of each component and one end of each loose segment.
std::vector<Eigen::Vector3d> pointsOfComponents(const RepairedMesh& mesh);

}  // namespace collision_hulls
