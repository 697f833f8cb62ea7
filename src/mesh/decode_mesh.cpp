// From bytes to triangles: each format has its reader.
#include "mesh/decode_mesh.h"

#include <string_view>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "mesh/formats/readers.h"

namespace collision_hulls {
namespace {

/// The start of a Git LFS pointer, which stands in for a file not fetched.
constexpr std::string_view kLfsPointer = "version https://git-lfs.github.com/spec/";

}  // namespace

LoadedMesh decodeMesh(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control) {
  if (bytes.empty()) throw Error(ErrorCode::kEmptyMesh, name + ": the file is empty (0 bytes); export the mesh again");
  if (bytes.compare(0, kLfsPointer.size(), kLfsPointer) == 0)
    throw Error(ErrorCode::kNotAMesh, name + ": a Git LFS pointer, not the mesh itself; fetch the mesh with 'git lfs pull'");
  const std::string extension = lowerExtension(name);
  if (extension == ".stl") return readStl(bytes, name, limits, control);
  if (extension == ".obj") return readObj(bytes, name, limits, control);
  if (extension == ".off") return readOff(bytes, name, limits, control);
  if (extension == ".glb" || extension == ".gltf") return readGltf(bytes, name, limits, control);
  if (extension == ".ply") return readPly(bytes, name, limits, control);
  return readDae(bytes, name, limits, control);
}

}  // namespace collision_hulls
