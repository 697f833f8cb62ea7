// Bytes as text (RFC 4648, section 4).
#pragma once

#include <string>

namespace collision_hulls {

std::string base64(const std::string& bytes);

}  // namespace collision_hulls
