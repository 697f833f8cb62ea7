// Which triangles to flip to give a mesh one outside.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"

namespace collision_hulls {

/// A patch is a set of triangles connected across manifold edges; a component may consist of several patches that meet at non-manifold
/// edges.
struct OrientedPatches {
  std::vector<char> turn;  ///< per triangle: 1 if it has to be flipped
  std::vector<int> patch;  ///< per triangle: its patch, numbered in order of first triangle
  std::size_t patches = 0;
};

///  1. Makes each patch consistent by flipping the part with the smaller area.
///   2. Flips a component if its patches, closed by fans over their boundary loops, together enclose a negative volume.
///   3. Flips a patch that is closed on its own (its fans are below a tenth of its area) and encloses a negative volume.
/// A volume that is negligible for its area (a flat sheet) decides nothing. A patch that cannot be oriented (a Moebius strip) keeps a seam
/// along which its triangles disagree.
OrientedPatches orient(const TriangleMesh& mesh, const Edges& edges, const RunControl& control);

/// A surface whose fans are below this share of its area counts as closed.
constexpr double kSmallOpening = 0.1;
/// A volume below this share of area^1.5 is negligible: a plate that thin is thinner than any the weld tolerance leaves.
constexpr double kNilVolume = 1e-6;

}  // namespace collision_hulls
