// Whole files as bytes, which are then hashed and parsed: what is certified is what was hashed.
#pragma once

#include <cstdint>
#include <string>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// The content of a regular file. It is opened once, and its kind and size are looked at before a byte is read, so a FIFO, a device or a
/// file that is too large costs nothing. `kind` stands in messages: "mesh". Throws kFileNotFound for what is not there, not a regular file
/// or not readable, and for a file that shrinks meanwhile; kTooLarge above `most_bytes`; kCancelled.
std::string readFile(const std::string& path, const std::string& kind, std::uintmax_t most_bytes, const RunControl& control = {});

}  // namespace collision_hulls
