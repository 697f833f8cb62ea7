// glTF meshes, as text or binary.
#include "fuzz/mesh.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {

const Registered kGltf("gltf", [](const std::string& bytes) { takeMesh(bytes, "input.glb"); });

}  // namespace collision_hulls::fuzz
