// Reading meshes from bytes in this process, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "decode/decode_mesh.h"

namespace collision_hulls {
namespace test_files {

/// What parseMesh() does, without the process that it hands most formats to.
inline LoadedMesh readHere(const std::string& bytes, const std::string& name, const MeshLimits& limits = {},
                           const RunControl& control = {}) {
  return decodeMesh(bytes, name, limits, control);
}

/// A .glb file of two chunks; the JSON has to have a length that is a multiple of four.
inline std::string glb(const std::string& json, const std::string& binary) {
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
    return bytes;
  };
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json + word(binary.size()) +
         std::string("BIN\0", 4) + binary;
}

/// A file's bytes that must not be read, and what the message must say.
struct Refused {
  std::string bytes, part;
  ErrorCode code = ErrorCode::kNotAMesh;
};

inline void expectRefused(const std::string& name, const std::vector<Refused>& cases) {
  for (const Refused& c : cases) {
    try {
      readHere(c.bytes, name);
      ADD_FAILURE() << "was read; expected '" << c.part << "':\n" << c.bytes;
    } catch (const Error& error) {
      EXPECT_EQ(c.code, error.code()) << error.what();
      EXPECT_NE(std::string::npos, std::string(error.what()).find(c.part)) << "expected '" << c.part << "': " << error.what();
    }
  }
}

/// Expects that a file is read as these vertices and triangles.
inline void expectMesh(const std::string& name, const std::string& bytes, const std::vector<Eigen::Vector3d>& vertices,
                       const std::vector<Triangle>& triangles) {
  SCOPED_TRACE(bytes);
  try {
    const LoadedMesh loaded = readHere(bytes, name);
    EXPECT_EQ(loaded.mesh.vertices, vertices);
    EXPECT_EQ(loaded.mesh.triangles, triangles);
  } catch (const Error& error) {
    ADD_FAILURE() << error.what();
  }
}

/// Spellings of numbers that other readers take for something else.
inline const std::vector<std::string>& misspeltNumbers() {
  static const std::vector<std::string> words{"1,5", "1.0f",  "0x10", "1_000", "1.#QNAN", "1.#INF",
                                              "--3", "1.5.2", "1e",   "1-2",   "one",     "1d5"};
  return words;
}

}  // namespace test_files
}  // namespace collision_hulls
