// Meshes as a page holds them: small, and good enough to be looked at.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Vertices on a grid of cubes: origin + step * (x, y, z) [m]. No two are equal, and no triangle has two equal corners.
struct DrawnMesh {
  static constexpr int kMostCells = 65535;  ///< along each axis

  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double step = 0;
  std::vector<std::array<std::uint16_t, 3>> vertices;
  std::vector<Triangle> triangles;
};

/// A mesh with 16 bits for each coordinate and at most `most_triangles`, thinned where it has more. Triangles that have a corner that is no
/// point, or further away than 1e6 m, are left out. Deterministic; nearly linear in the number of triangles. Throws
/// kCancelled.
DrawnMesh drawnMesh(const TriangleMesh& mesh, std::size_t most_triangles, const RunControl& control = {});

/// Its bytes, little-endian: vertices (3 * uint16), then triangles (3 * uint8 up to 256 vertices, uint16 up to 65536, else uint32); each of
/// the two begins at a multiple of four bytes, and so does the end.
std::string toPageBytes(const DrawnMesh& mesh);
int indexBytes(std::size_t vertices);  ///< 1, 2 or 4

}  // namespace collision_hulls
