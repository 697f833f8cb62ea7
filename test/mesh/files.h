// Mesh files made up by tests.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace collision_hulls {
namespace test_files {

/// A file in a temporary folder of this process; the folder is removed with it.
class TempFile {
 public:
  TempFile(const std::string& name, const std::string& bytes)
      : folder_(std::filesystem::temp_directory_path() / ("collision_hulls_mesh_" + std::to_string(getpid()))), path_(folder_ / name) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TempFile() { std::filesystem::remove_all(folder_); }
  TempFile(const TempFile&) = delete;
  TempFile& operator=(const TempFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path folder_, path_;
};

template <typename Number>
std::string raw(Number number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(&bytes[0], &number, sizeof number);
  return bytes;
}

/// A binary STL with `triangles` copies of the right triangle (0 0 0) (1 0 0) (0 1 0) that announces `announced` of them.
inline std::string binaryStl(const std::string& header, std::uint32_t triangles, std::uint32_t announced) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += raw(announced);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += raw(x);
    bytes += raw(std::uint16_t{0});
  }
  return bytes;
}

/// A Collada file around a geometry "shape" with the vertices (0 0 0) (1 0 0) (1 2 0) (0 2 0) (0 0 3), and a scene.
inline std::string dae(const std::string& asset, const std::string& primitives, const std::string& scene,
                       const std::string& library_nodes = "") {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>)" +
         asset + R"(</asset>
<library_geometries><geometry id="shape"><mesh>
<source id="positions"><float_array id="array" count="15">0 0 0  1 0 0  1 2 0  0 2 0  0 0 3</float_array>
<technique_common><accessor source="#array" count="5" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="corners"><input semantic="POSITION" source="#positions"/></vertices>
)" + primitives +
         R"(
</mesh></geometry></library_geometries>
)" + library_nodes +
         R"(
<library_visual_scenes><visual_scene id="scene">)" +
         scene + R"(</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene></COLLADA>
)";
}

inline std::string unit(const std::string& meter) {
  return "<unit meter=\"" + meter + "\"/>";
}

const std::string kVertexInput = R"(<input semantic="VERTEX" source="#corners" offset="0"/>)";

/// Two triangles that span the box from (0 0 0) to (1 2 3).
const std::string kTwoTriangles = R"(<triangles count="2">)" + kVertexInput + "<p>0 1 2 0 2 4</p></triangles>";

const std::string kPlainNode = R"(<node id="n"><instance_geometry url="#shape"/></node>)";

}  // namespace test_files
}  // namespace collision_hulls
