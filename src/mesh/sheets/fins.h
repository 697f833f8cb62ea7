// Sheets that hang, inside or outside, on a surface that is complete without them.
#pragma once

#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"
#include "mesh/orient.h"

namespace collision_hulls {

/// Per triangle: 1 if it belongs to a fin, which encloses nothing. A fin is a patch with open edges and with non-manifold edges where the
/// other triangles use the edge equally often in both directions; closing it would take a tenth of its area or more. Triangles marked in
/// `oriented.turn` count as flipped.
///
/// A wall shared by two solids is a fin, too: a patch without open edges whose triangles all have `surplus` zero (copies that face the same
/// way minus copies that face the other) and which hangs in the same manner once all such walls are left out. What hangs only on fins and
/// walls, or on itself, is neither.
std::vector<char> findFins(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, const std::vector<int>& surplus,
                           const RunControl& control);

}  // namespace collision_hulls
