// OBJ meshes.
#include "fuzz/mesh.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {

const Registered kObj("obj", [](const std::string& bytes) { takeMesh(bytes, "input.obj"); });

}  // namespace collision_hulls::fuzz
