// Checks, made beforehand, of what Assimp takes on trust in Collada.
#pragma once

#include <string>
#include <string_view>

namespace collision_hulls {

/// Throws kNotAMesh, kIndexOutOfRange or kTooLarge. `path` stands in messages.
void checkDae(std::string_view bytes, const std::string& path);

}  // namespace collision_hulls
