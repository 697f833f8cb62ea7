// What the readers of meshes have in common.
#pragma once

#include <algorithm>

#include "collision_hulls/mesh/mesh_io.h"
#include "decode/decode_mesh.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {

/// Reads a mesh in this process. What is read has to be sound.
inline void takeMesh(const std::string& bytes, const std::string& name) {
  MeshLimits limits;
  limits.max_triangles = 100'000;
  const LoadedMesh loaded = decodeMesh(bytes, name, limits, {});
  const auto count = static_cast<int>(loaded.mesh.vertices.size());
  expect(!loaded.mesh.triangles.empty(), "a mesh has triangles");
  for (const Triangle& t : loaded.mesh.triangles)
    for (const int v : t) expect(v >= 0 && v < count, "indices are of vertices");
  for (const Eigen::Vector3d& v : loaded.mesh.vertices) expect(v.allFinite(), "coordinates are finite");
}

}  // namespace collision_hulls::fuzz
