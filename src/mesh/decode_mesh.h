// From the bytes of a mesh file to its triangles, in this process.
#pragma once

#include <string>
#include <string_view>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

/// Whether bytes are a Git LFS pointer, which stands in for a file that was not fetched.
bool isLfsPointer(std::string_view bytes);

/// Throws kEmptyMesh and kNotAMesh for what is no mesh of any format: no bytes, and a Git LFS pointer.
void expectMeshFile(std::string_view bytes, const std::string& name);

/// What parseMesh() does.
LoadedMesh decodeMesh(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control);

}  // namespace collision_hulls
