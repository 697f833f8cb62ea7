// What it takes to close an open surface.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

double triangleArea(const TriangleMesh& mesh, int triangle);  ///< [m^2]

/// A boundary edge of a surface, in its triangle's direction.
struct BoundaryEdge {
  int surface;  ///< number of the surface it bounds
  int from;
  int to;
};

/// Half-edge `half_edge` (see edges.h) as a boundary edge, with the triangles marked in `turn` flipped. `surface`: per triangle, the number
/// of its surface.
BoundaryEdge boundaryEdge(const TriangleMesh& mesh, int half_edge, const std::vector<char>& turn, const std::vector<int>& surface);

/// The fans that close a surface, one over each boundary loop about its mean vertex.
struct Closure {
  double area = 0;    ///< [m^2]
  double volume = 0;  ///< [m^3] of the tetrahedra from the fans to the origin: what the surface's own tetrahedra lack
};

/// The closures of `surfaces` surfaces. Opposite edges of a surface cancel and are ignored. Loops that touch at a vertex are closed
/// separately. A chain that does not return (the boundary of a non-orientable surface) counts as a loop.
std::vector<Closure> closures(const std::vector<Eigen::Vector3d>& vertices, std::vector<BoundaryEdge> boundary, std::size_t surfaces,
                              const Eigen::Vector3d& origin, const RunControl& control);

}  // namespace collision_hulls
