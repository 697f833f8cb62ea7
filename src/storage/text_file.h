// Text files that a user names, whole.
#pragma once

#include <string>

namespace collision_hulls {

/// The content of a file, byte for byte. `kind` stands in messages: "robot description". Throws kFileNotFound for what is not there, a
/// folder, and what cannot be read; kTooLarge above 256 MiB, which no such text has, so that an endless file (a device) does not fill the
/// memory.
std::string readTextFile(const std::string& path, const std::string& kind);

}  // namespace collision_hulls
