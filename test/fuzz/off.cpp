// OFF meshes.
#include "fuzz/mesh.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {

const Registered kOff("off", [](const std::string& bytes) { takeMesh(bytes, "input.off"); });

}  // namespace collision_hulls::fuzz
