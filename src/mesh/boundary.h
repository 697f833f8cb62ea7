// What it takes to close an open surface.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

double triangleArea(const TriangleMesh& mesh, int triangle);  ///< [m^2]

/// Of the tetrahedron from `origin` to a triangle [m^3]; negative if the triangle faces the origin.
double volumeBehind(const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& origin);

/// A boundary edge of a surface, in its triangle's direction.
struct BoundaryEdge {
  int surface;  ///< number of the surface it bounds
  int from;
  int to;
};

/// Half-edge `half_edge` (see edges.h) as a boundary edge, with the triangles marked in `turn` flipped. `surface`: per triangle, the number
/// of its surface.
BoundaryEdge boundaryEdge(const TriangleMesh& mesh, int half_edge, const std::vector<char>& turn, const std::vector<int>& surface);

/// A simple loop of boundary edges of a surface: its vertices, in the edges' direction.
struct BoundaryLoop {
  int surface;
  std::vector<int> vertices;
  bool returns = true;  ///< false for a chain that does not (the boundary of a non-orientable surface): its ends are not joined by an edge
};

/// The loops of `boundary`. Opposite edges of a surface cancel and are ignored. Loops that touch at a vertex are separate ones. `vertices`:
/// of the mesh.
std::vector<BoundaryLoop> boundaryLoops(std::size_t vertices, std::vector<BoundaryEdge> boundary, const RunControl& control);

/// The area of the fan over a loop about its mean vertex [m^2].
double fanArea(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& loop);

/// The fans that close a surface, one over each boundary loop about its mean vertex.
struct Closure {
  double area = 0;    ///< [m^2]
  double volume = 0;  ///< [m^3] of the tetrahedra from the fans to the origin: what the surface's own tetrahedra lack
};

/// The closures of `surfaces` surfaces, over their boundaryLoops(). A chain that does not return counts as a loop.
std::vector<Closure> closures(const std::vector<Eigen::Vector3d>& vertices, std::vector<BoundaryEdge> boundary, std::size_t surfaces,
                              const Eigen::Vector3d& origin, const RunControl& control);

}  // namespace collision_hulls
