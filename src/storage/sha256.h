// SHA-256 (FIPS 180-4), which identifies inputs in reports and finds equal meshes, and HMAC, which proves who made a cache entry.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// The digest of the bytes, as 64 lower-case hexadecimal digits. Throws kCancelled: a mesh of a gigabyte takes seconds.
std::string sha256(std::string_view bytes, const RunControl& control = {});

/// The same, keyed: HMAC-SHA-256 (RFC 2104) of the parts, one after the other. `key`: at most 64 bytes.
std::string hmacSha256(std::string_view key, std::initializer_list<std::string_view> parts);

}  // namespace collision_hulls
