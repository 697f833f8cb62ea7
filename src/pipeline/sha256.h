// SHA-256 (FIPS 180-4): what names the content of an input in reports and tells equal meshes.
#pragma once

#include <string>

namespace collision_hulls {

/// The digest of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256(const std::string& bytes);

/// The digest of a file's content. Throws kFileNotFound where it is no readable regular file.
std::string sha256OfFile(const std::string& path);

}  // namespace collision_hulls
