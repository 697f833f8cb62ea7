// SHA-256 (FIPS 180-4), which identifies inputs in reports and finds equal meshes.
#pragma once

#include <string>

namespace collision_hulls {

/// The digest of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256(const std::string& bytes);

}  // namespace collision_hulls
