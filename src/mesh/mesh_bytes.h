// All bytes of a mesh, which are then hashed and parsed: what is certified is what was hashed.
#pragma once

#include <string>
#include <string_view>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

/// The content of a mesh file. A .gltf file whose buffers are in other files is packed with them (formats/gltf_container.h), so that equal
/// bytes are equal meshes, and parseMesh() reads them under the file's name. `limits.max_bytes` is for all files together. Throws what
/// readFile() throws; of a .gltf file also what parseMesh() throws, and kOutsideRoots for a buffer that does not lie in the mesh's folder
/// or below.
std::string readMeshBytes(const std::string& path, const MeshLimits& limits, const RunControl& control = {});

/// Whether bytes are a Git LFS pointer, which stands in for a file that was not fetched.
bool isLfsPointer(std::string_view bytes);

/// Throws kEmptyMesh and kNotAMesh for what is no mesh of any format: no bytes, and a Git LFS pointer.
void expectMeshFile(std::string_view bytes, const std::string& name);

}  // namespace collision_hulls
