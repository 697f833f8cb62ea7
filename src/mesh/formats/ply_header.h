// The header of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace collision_hulls {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

std::size_t bytesOf(PlyType type);
bool isInteger(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat;
  std::optional<PlyType> count;  // of a list: the type of its number of values
};

struct PlyElement {
  std::string name;
  std::size_t rows = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum class Format { kText, kLittleEndian, kBigEndian };
  Format format = Format::kText;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;  // how many it takes
  std::string_view data;  // what follows it
};

/// Throws kNotAMesh for a header that says anything but what a PLY file may, or too much: rows that the data cannot hold, or an element
/// that carries surface as something other than faces.
PlyHeader readPlyHeader(std::string_view bytes, const std::string& path);

}  // namespace collision_hulls
