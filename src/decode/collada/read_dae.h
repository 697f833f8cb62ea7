// Collada.
#pragma once

#include <string>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

/// Takes a file's bytes and its path for messages. Throws what parseMesh() throws.
LoadedMesh readDae(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control);

}  // namespace collision_hulls
