// Text files that a user names, whole.
#pragma once

#include <string>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// The content of a regular file, byte for byte. `kind` stands in messages: "robot description". Throws as readFile() does: kFileNotFound
/// for what is not there, no regular file, or cannot be read; kTooLarge above 256 MiB, which no such text has.
std::string readTextFile(const std::string& path, const std::string& kind, const RunControl& control = {});

/// The same, also from a pipe: see readFileOrPipe().
std::string readTextFileOrPipe(const std::string& path, const std::string& kind, const RunControl& control);

}  // namespace collision_hulls
