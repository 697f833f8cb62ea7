// Reads a mesh: the file as bytes, and triangles from them.
//
// A program of its own, confined by the kernel, reads all that needs a parser (mesh_question.h). Binary STL is fifteen lines of our own
// that check the size before they copy numbers; it is read here, where no bytes have to be passed on.
#include <algorithm>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "mesh/formats/readers.h"
#include "mesh/mesh_bytes.h"
#include "mesh/mesh_question.h"

namespace collision_hulls {
namespace {

void checkExtension(const std::string& name) {
  if (isMeshFile(name)) return;
  std::string list;
  for (const std::string& e : meshExtensions()) list += " " + e;
  throw Error(ErrorCode::kUnsupportedFormat,
              name + ": extension '" + lowerExtension(name) + "' is not supported; convert the file to one of" + list);
}

/// `bytes`: within the limit.
LoadedMesh decoded(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control) {
  control.check();
  if (lowerExtension(name) == ".stl" && isBinaryStl(bytes)) return readStl(bytes, name, limits, control);
  return decodeInWorker(bytes, name, limits, control);
}

}  // namespace

const std::vector<std::string>& meshExtensions() {
  static const std::vector<std::string> extensions{".stl", ".dae", ".obj", ".off", ".ply", ".glb", ".gltf"};
  return extensions;
}

bool isMeshFile(const std::string& path) {
  const std::vector<std::string>& known = meshExtensions();
  return std::find(known.begin(), known.end(), lowerExtension(path)) != known.end();
}

LoadedMesh readMesh(const std::string& path, const MeshLimits& limits, const RunControl& control) {
  checkExtension(path);
  return decoded(readMeshBytes(path, limits, control), path, limits, control);
}

LoadedMesh parseMesh(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control) {
  checkExtension(name);
  if (bytes.size() > limits.max_bytes)
    throw Error(ErrorCode::kTooLarge, name + ": has " + std::to_string(bytes.size()) + " bytes, above the limit of " +
                                          std::to_string(limits.max_bytes) + " for a mesh; give a smaller one");
  return decoded(bytes, name, limits, control);
}

}  // namespace collision_hulls
