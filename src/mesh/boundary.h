// What it would take to close an open surface.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

double triangleArea(const TriangleMesh& mesh, int triangle);  ///< [m^2]

/// A boundary edge of a surface, in the direction of its triangle.
struct BoundaryEdge {
  int surface;  ///< number of the surface that it bounds
  int from;
  int to;
};

/// Half-edge `half_edge` (see edges.h) as a boundary edge, where the triangles marked in `turn` are turned over. `surface`: per
/// triangle, the number of the surface that it belongs to.
BoundaryEdge boundaryEdge(const TriangleMesh& mesh, int half_edge, const std::vector<char>& turn, const std::vector<int>& surface);

/// The fans that close a surface, one over each boundary loop, about the loop's mean vertex.
struct Closure {
  double area = 0;    ///< [m^2]
  double volume = 0;  ///< [m^3] of the tetrahedra of the fans to the origin: what the surface's own tetrahedra lack
};

/// The closures of `surfaces` surfaces. Edges of a surface that run against each other close each other and take no part. Loops
/// that touch at a vertex are taken one by one; a chain that returns nowhere (the boundary of a surface that cannot be
/// oriented) counts as a loop.
std::vector<Closure> closures(const std::vector<Eigen::Vector3d>& vertices, std::vector<BoundaryEdge> boundary, std::size_t surfaces,
                              const Eigen::Vector3d& origin);

}  // namespace collision_hulls
