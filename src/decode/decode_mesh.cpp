// From bytes to triangles: each format has its reader.
#include "decode/decode_mesh.h"

#include "base/string_parts.h"
#include "decode/collada/read_dae.h"
#include "mesh/formats/readers.h"
#include "mesh/mesh_bytes.h"

namespace collision_hulls {

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
