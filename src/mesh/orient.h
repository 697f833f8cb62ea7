// Which triangles to turn over, so that a mesh has one outside.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"

namespace collision_hulls {

/// A patch is a set of triangles connected across manifold edges; a component may consist of several patches that meet at
/// non-manifold edges.
struct OrientedPatches {
  std::vector<char> turn;  ///< per triangle: 1 where it has to be turned over
  std::vector<int> patch;  ///< per triangle: its patch, numbered in order of first triangle
  std::size_t patches = 0;
};

///   1. Each patch is made consistent, turning over the smaller part of its area.
///   2. A component whose patches, closed by fans over their boundary loops, enclose a negative volume in sum is turned over.
///   3. A patch that is closed on its own (the fans are below a tenth of its area) and encloses a negative volume is turned over.
/// A volume that is nil for the area (a flat sheet) decides nothing. A patch that cannot be oriented (a Moebius strip) keeps a
/// seam where its triangles disagree.
OrientedPatches orient(const TriangleMesh& mesh, const Edges& edges);

/// Fans below this share of a surface's area leave it as good as closed.
constexpr double kSmallOpening = 0.1;

}  // namespace collision_hulls
