// Meshes whose facets lie a little apart.
#pragma once

#include <random>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Gives each triangle three vertices of its own, each moved by up to `jitter` along each axis.
inline TriangleMesh soup(const TriangleMesh& mesh, double jitter, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-jitter, jitter);
  TriangleMesh result;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const int first = static_cast<int>(result.vertices.size());
    for (int k = 0; k < 3; ++k)
      result.vertices.push_back(mesh.corner(t, k) + Eigen::Vector3d(offset(random), offset(random), offset(random)));
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

}  // namespace collision_hulls
