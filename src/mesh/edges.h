// Which triangles meet at which edges: the mesh's half-edges and its edge-connected components.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Half-edge h = 3 * t + k runs from corner k of triangle t to corner k + 1.
struct Edges {
  static constexpr int kOpen = -1;         ///< no other triangle has this edge
  static constexpr int kNonManifold = -2;  ///< two or more other triangles have this edge

  std::vector<int> twin;       ///< per half-edge: the other triangle's half-edge on the same edge, or kOpen or kNonManifold
  std::vector<int> component;  ///< per triangle: its edge-connected component, numbered in order of first triangle
  std::size_t components = 0;
  std::size_t open = 0;         ///< edges with one triangle
  std::size_t nonmanifold = 0;  ///< edges with more than two triangles
};

/// Near-linear in the size of the mesh. Each triangle must have three different corners, all below `vertices`.
Edges findEdges(const std::vector<Triangle>& triangles, std::size_t vertices, const RunControl& control);

/// Start and end of a half-edge.
inline int startOf(const std::vector<Triangle>& triangles, int h) {
  return triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
}
inline int endOf(const std::vector<Triangle>& triangles, int h) {
  return triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3 == 2 ? 0 : h % 3 + 1)];
}

}  // namespace collision_hulls
