// Checks, made beforehand, of everything that Assimp's readers take on trust.
//
// These readers clamp or drop what is out of range, allocate whatever a header announces, read past arrays, and stop silently where a file
// is truncated. A file that passes these checks is read completely or not at all.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace collision_hulls {

/// The counts that a file announces; Assimp has to find the same.
struct Announced {
  std::size_t vertices = 0, faces = 0;  // faces with at least one corner
};

/// Each takes a file's bytes, and its path for messages; `max_triangles` bounds what the file announces. Throws kNotAMesh, kEmptyMesh,
/// kIndexOutOfRange or kTooLarge.
void checkStl(std::string_view bytes, const std::string& path, std::size_t max_triangles);
void checkObj(std::string_view bytes, const std::string& path);
Announced checkOff(std::string_view bytes, const std::string& path, std::size_t max_triangles);
Announced checkPly(std::string_view bytes, const std::string& path, std::size_t max_triangles);
void checkDae(std::string_view bytes, const std::string& path);

/// Whether a file's size is that of a binary STL with as many triangles as it announces.
bool isBinaryStl(std::string_view bytes);
constexpr std::size_t kStlHeaderBytes = 84;  ///< including the number of triangles
constexpr std::size_t kStlFacetBytes = 50;   ///< normal, three corners, two bytes

}  // namespace collision_hulls
