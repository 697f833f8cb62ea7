// Each reads one format from a file's bytes.
//
// Those of glTF, OBJ, OFF, PLY and STL are our own: every library that we know takes numbers leniently ("1,5" for 1 or 1.5, "0x10" for 0)
// and skips what it does not understand, so what it reads need not be what the file says. Here a file is read completely or not at all:
// what may carry surface and is not understood is an error that names the line.
#pragma once

#include <string>
#include <string_view>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

/// Each takes a file's bytes and its path for messages. Throws what parseMesh() throws.
LoadedMesh readStl(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control);
LoadedMesh readObj(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control);
LoadedMesh readOff(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control);
LoadedMesh readPly(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control);
LoadedMesh readGltf(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control);

/// Whether a file's size is that of a binary STL with as many triangles as it announces: what readStl() reads as one.
bool isBinaryStl(std::string_view bytes);

}  // namespace collision_hulls
