// Where a surface is not closed.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/mesh/repair.h"
#include "mesh/edges.h"

namespace collision_hulls {

/// Edges as pairs (from, to).
using Rim = std::vector<std::array<int, 2>>;

/// The boundary of the oriented surface without its sheets: the edges that triangles do not use equally often in both directions, in the
/// direction that prevails and as many times as it does.
Rim rimOf(const RepairedMesh& mesh, const Edges& edges, const RunControl& control);

/// A simple cycle of vertices.
using Loop = std::vector<int>;

/// Splits the rim into loops. It is a cycle: at each vertex as many of its edges begin as end. Of the edges that leave a vertex, the one is
/// taken that turns back most; the two sides of a crack then form one loop.
std::vector<Loop> loopsOf(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim, const RunControl& control);

}  // namespace collision_hulls
