// From the bytes of a mesh file to its triangles, in this process.
#pragma once

#include <string>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

/// What parseMesh() does.
LoadedMesh decodeMesh(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control);

}  // namespace collision_hulls
