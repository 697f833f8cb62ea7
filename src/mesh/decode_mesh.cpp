// From bytes to triangles: each format has its reader.
#include "mesh/decode_mesh.h"

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "mesh/formats/readers.h"

namespace collision_hulls {
namespace {

constexpr std::string_view kLfsPointer = "version https://git-lfs.github.com/spec/";

}  // namespace

bool isLfsPointer(std::string_view bytes) {
  return bytes.substr(0, kLfsPointer.size()) == kLfsPointer;
}

void expectMeshFile(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw Error(ErrorCode::kEmptyMesh, name + ": the file is empty (0 bytes); export the mesh again");
  if (isLfsPointer(bytes))
    throw Error(ErrorCode::kNotAMesh, name + ": a Git LFS pointer, not the mesh itself; fetch the mesh with 'git lfs pull'");
}

LoadedMesh decodeMesh(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control) {
  expectMeshFile(bytes, name);
  const std::string extension = lowerExtension(name);
  if (extension == ".stl") return readStl(bytes, name, limits, control);
  if (extension == ".obj") return readObj(bytes, name, limits, control);
  if (extension == ".off") return readOff(bytes, name, limits, control);
  if (extension == ".glb" || extension == ".gltf") return readGltf(bytes, name, limits, control);
  if (extension == ".ply") return readPly(bytes, name, limits, control);
  return readDae(bytes, name, limits, control);
}

}  // namespace collision_hulls
