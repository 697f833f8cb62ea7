// STL meshes, text and binary.
#include "fuzz/mesh.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {

const Registered kStl("stl", [](const std::string& bytes) { takeMesh(bytes, "input.stl"); });

}  // namespace collision_hulls::fuzz
