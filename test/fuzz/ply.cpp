// PLY meshes, text and binary.
#include "fuzz/mesh.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {

const Registered kPly("ply", [](const std::string& bytes) { takeMesh(bytes, "input.ply"); });

}  // namespace collision_hulls::fuzz
