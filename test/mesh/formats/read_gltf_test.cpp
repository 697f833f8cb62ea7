// Also tests src/mesh/formats/gltf_document.cpp.
#include <gtest/gtest.h>

#include <cstring>

#include "../reading.h"
#include "mesh/formats/gltf_container.h"

namespace collision_hulls {
namespace {

using namespace test_files;

/// Three points in a line of floats, then the indices 0 1 2 as bytes, then three triples of 16-bit numbers.
std::string someBytes() {
  const float points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::int16_t small[] = {0, 0, 0, 32767, 0, 0, 0, -32768, 0};
  std::string bytes(reinterpret_cast<const char*>(points), sizeof points);
  bytes += std::string("\0\1\2\0", 4);
  bytes.append(reinterpret_cast<const char*>(small), sizeof small);
  return bytes + std::string(2, '\0');
}

struct Parts {
  std::string nodes = R"([{"mesh": 0}])", primitives = R"([{"attributes": {"POSITION": 0}}])", more, accessors;
};

std::string json(const Parts& parts) {
  return R"({"asset": {"version": "2.0"}, )" + parts.more + R"("scenes": [{"nodes": [0]}], "nodes": )" + parts.nodes +
         R"(, "meshes": [{"primitives": )" + parts.primitives +
         R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
  {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"},
  {"bufferView": 2, "componentType": 5122, "count": 3, "type": "VEC3", "normalized": true})" +
         parts.accessors + R"(], "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 3},
  {"buffer": 0, "byteOffset": 40, "byteLength": 18}], "buffers": [{"byteLength": 58}]})";
}

std::string file(const Parts& parts) {
  std::string text = json(parts);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  return glb(text, someBytes());
}

std::string withPrimitives(const std::string& primitives, const std::string& accessors = "") {
  Parts parts;
  parts.primitives = primitives;
  parts.accessors = accessors;
  return file(parts);
}

std::string withNodes(const std::string& nodes) {
  Parts parts;
  parts.nodes = nodes;
  return file(parts);
}

const std::vector<Eigen::Vector3d> kCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(ReadGltf, ATriangle) {
  expectMesh("a.glb", file({}), kCorners, {{0, 1, 2}});
  expectMesh("a.GLB", withPrimitives(R"([{"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}])"), kCorners, {{0, 1, 2}});
}

TEST(ReadGltf, AsTextWithItsBytes) {
  std::string text = json({});
  const std::string bytes =
      R"("uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAEC", "byteLength": 39)";
  text.replace(text.find(R"("byteLength": 58)"), 16, bytes);
  expectMesh("a.gltf", text, kCorners, {{0, 1, 2}});
  expectMesh("a.gltf", "\xEF\xBB\xBF" + text, kCorners, {{0, 1, 2}});
}

TEST(ReadGltf, NodesPlaceTheirMeshes) {
  expectMesh("a.glb", withNodes(R"([{"children": [1], "translation": [0, 0, 5]},
      {"mesh": 0, "scale": [2, 1, 1], "rotation": [0, 0, 1, 0]}])"),
             {{0, 0, 5}, {-2, 0, 5}, {0, -1, 5}}, {{0, 1, 2}});
  expectMesh("a.glb", withNodes(R"([{"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1]}])"),
             {{7, 8, 9}, {8, 8, 9}, {7, 9, 9}}, {{0, 1, 2}});
  const LoadedMesh twice = readHere(withNodes(R"([{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "translation": [0, 0, 1]}])"), "a.glb");
  EXPECT_EQ(twice.mesh.triangles.size(), 2u);
  EXPECT_EQ(twice.submeshes, 2u);
}

TEST(ReadGltf, PrimitivesThatShareTheirPointsStandWhereTheirNodesDo) {
  Parts twice;
  twice.nodes = R"([{"mesh": 0, "children": [1]}, {"mesh": 0, "translation": [0, 0, 1]}])";
  twice.primitives = R"([{"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 0}, "indices": 1}])";
  std::vector<Eigen::Vector3d> corners;
  for (const double z : {0, 0, 1, 1})
    for (const Eigen::Vector3d& corner : kCorners) corners.emplace_back(corner.x(), corner.y(), z);
  expectMesh("twice.glb", file(twice), corners, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}});
}

TEST(ReadGltf, OnlyTheDefaultScene) {
  Parts parts;
  parts.nodes = R"([{"mesh": 0}, {"mesh": 0, "translation": [0, 0, 9]}])";
  EXPECT_EQ(readHere(file(parts), "a.glb").mesh.triangles.size(), 1u);
  std::string text = json(parts);
  const std::string scenes = R"("scenes": [{"nodes": [0]}], )";
  std::string other = text, none = text;
  other.replace(other.find(scenes), scenes.size(), R"("scene": 1, "scenes": [{"nodes": [0]}, {"nodes": [1]}], )");
  none.erase(none.find(scenes), scenes.size());
  for (std::string* each : {&other, &none}) each->resize((each->size() + 3) / 4 * 4, ' ');
  EXPECT_EQ(readHere(glb(other, someBytes()), "a.glb").mesh.vertices[0].z(), 9);
  EXPECT_EQ(readHere(glb(none, someBytes()), "a.glb").mesh.triangles.size(), 2u);
}

TEST(ReadGltf, SmallNumbersAndChangedOnes) {
  expectMesh("a.glb", withPrimitives(R"([{"attributes": {"POSITION": 2}}])"), {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}});
  expectMesh("a.glb", withPrimitives(R"([{"attributes": {"POSITION": 3}}])", R"(, {"componentType": 5126, "count": 3, "type": "VEC3",
      "sparse": {"count": 2, "indices": {"bufferView": 1, "byteOffset": 1, "componentType": 5121}, "values": {"bufferView": 0, "byteOffset": 12}}})"),
             kCorners, {{0, 1, 2}});
}

TEST(ReadGltf, PointsAndLinesAreLeftOut) {
  const LoadedMesh loaded = readHere(withPrimitives(R"([{"attributes": {"POSITION": 0}, "mode": 0}, {"attributes": {"POSITION": 0}},
      {"attributes": {"POSITION": 0}, "mode": 1}])"),
                                     "a.glb");
  EXPECT_EQ(loaded.mesh.triangles.size(), 1u);
  EXPECT_EQ(loaded.skipped_primitives, 2u);
}

TEST(ReadGltf, WhatIsNotUnderstoodIsRefused) {
  const auto with = [](const std::string& more) {
    Parts parts;
    parts.more = more;
    return file(parts);
  };
  EXPECT_NO_THROW(readHere(with(R"("extensionsRequired": ["KHR_materials_unlit", "KHR_mesh_quantization"], )"), "a.glb"));
  expectRefused(
      "a.glb", {{with(R"("extensionsRequired": ["KHR_draco_mesh_compression"], )"), "'KHR_draco_mesh_compression', which is not supported"},
                {withNodes(R"([{"mesh": 0, "skin": 0}])"), "nodes[0] is skinned"},
                {withPrimitives(R"([{"attributes": {"POSITION": 0}, "mode": 7}])"), "unknown mode 7"},
                {withNodes(R"([{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {}}}])"), "EXT_mesh_gpu_instancing"},
                {withPrimitives(R"([{"attributes": {"POSITION": 3}}])", R"(, {"componentType": 5126, "count": 3, "type": "VEC3"})"),
                 "accessors[3] has no bufferView"}});
}

TEST(ReadGltf, MorphTargetsCountOnlyInUse) {
  const std::string primitives = R"([{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 0}]}])";
  Parts parts;
  parts.primitives = primitives;
  EXPECT_NO_THROW(readHere(file(parts), "a.glb"));
  parts.nodes = R"([{"mesh": 0, "weights": [0]}])";
  EXPECT_NO_THROW(readHere(file(parts), "a.glb"));
  parts.nodes = R"([{"mesh": 0, "weights": [0.5]}])";
  expectRefused("a.glb", {{file(parts), "meshes[0] has morph targets in use"}});
}

TEST(ReadGltf, BrokenFilesNameTheItem) {
  std::string short_file = file({}), version = file({}), chunk = file({});
  short_file.pop_back();
  version[4] = 1;
  chunk[14] = '\x7F';
  std::string twice = json({}), deep = R"({"asset": )" + std::string(100, '[') + std::string(100, ']') + "}";
  twice.insert(1, R"("asset": {"version": "2.0"}, )");
  std::string elsewhere = json({});
  elsewhere.replace(elsewhere.find(R"("byteLength": 58)"), 16, R"("byteLength": 58, "uri": "part.bin")");
  expectRefused(
      "a.glb",
      {{short_file, "announces"},
       {version, "is glTF 1"},
       {chunk, "announces a chunk"},
       {twice, "'asset' twice"},
       {deep, "nested deeper"},
       {elsewhere, "buffers[0] is in another file, 'part.bin'; export the mesh as .glb"},
       {"{}", "export it as glTF 2"},
       {R"({"asset": {"version": "1.0"}, "buffers": {"all": {}}, "meshes": {}})", "is glTF \"1.0\"; export it as glTF 2"},
       {R"({"asset": {"version": "2.0"}, "extensionsRequired": ["EXT_meshopt_compression"], "buffers": [{"byteLength": 9}]})",
        "'EXT_meshopt_compression', which is not supported"},
       {"[]", "is not an object"},
       {"{", "is not JSON from byte 2"},
       {"{\"a\": 1e999}", "a number that is too large"},
       {withNodes(R"([{"children": [0]}])"), "nodes[0] is placed twice"},
       {withNodes(R"([{"mesh": 4}])"), "meshes[4], but there are 1"},
       {withNodes(R"([{"mesh": -1}])"), "nodes[0].mesh is '-1', no whole number"},
       {withNodes(R"([{"mesh": 0, "scale": [1, 2]}])"), "nodes[0].scale are not 3 numbers"},
       {withNodes(R"([{"mesh": 0, "rotation": [0, 0, 0, 2]}])"), "nodes[0].rotation is not a unit quaternion"},
       {withNodes(R"([{"mesh": 0, "matrix": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}])"), "nodes[0].matrix"},
       {withPrimitives(R"([{"attributes": {"POSITION": 1}}])"), "accessors[1] is not of type VEC3"},
       {withPrimitives(R"([{"attributes": {"POSITION": 0}, "indices": 0}])"), "accessors[0] holds indices"},
       {withPrimitives(R"([{"attributes": {}}])"), "without positions"},
       {withPrimitives(R"([{"attributes": {"POSITION": 3}}])", R"(, {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"})"),
        "accessors[3] leaves its bufferView"},
       {withPrimitives(R"([{"attributes": {"POSITION": 3}}])", R"(, {"bufferView": 0, "componentType": 5130, "count": 3, "type": "VEC3"})"),
        "unknown type 5130"},
       {withPrimitives(R"([{"attributes": {"POSITION": 0}, "indices": 3}])",
                       R"(, {"bufferView": 0, "byteOffset": 13, "componentType": 5121, "count": 3, "type": "SCALAR"})"),
        "names vertex 128 of 3", ErrorCode::kIndexOutOfRange},
       {withPrimitives(R"([{"attributes": {"POSITION": 3}}])", R"(, {"bufferView": 0, "componentType": 5126, "count": 900719925474099,
                  "type": "VEC3"})"),
        "accessors[3] has 900719925474099 elements", ErrorCode::kTooLarge}});
}

/// A packed file: this JSON, whose first buffer is in part.bin, with these files.
std::string packed(const std::string& buffer, const std::vector<std::string>& files) {
  std::string text = json({});
  text.replace(text.find(R"("byteLength": 58)"), 16, buffer);
  return packedGltf(text, files);
}

TEST(ReadGltf, PackedWithItsFiles) {
  const std::string part = R"("byteLength": 58, "uri": "part.bin")";
  expectMesh("a.gltf", packed(part, {someBytes()}), kCorners, {{0, 1, 2}});
  expectMesh("a.gltf",
             packed(part + R"(}, {"byteLength": 1, "uri": "part.bin"}, {"byteLength": 4, "uri": "other.bin")", {someBytes(), "1234"}),
             kCorners, {{0, 1, 2}});
  expectRefused("a.gltf", {{packed(part, {someBytes().substr(3)}), "buffers[0] announces 58 bytes, of which 57 are in 'part.bin'"},
                           {packed(part, {}), "names 1 files of buffers, but is packed with 0"},
                           {packed(part, {someBytes(), someBytes()}), "names 1 files of buffers, but is packed with 2"},
                           {packed(R"("byteLength": 58)", {someBytes()}), "names 0 files of buffers, but is packed with 1"},
                           {packed(R"("byteLength": 58)", {}), "buffers[0] announces 58 bytes, of which 0 are there"}});
}

TEST(ReadGltf, BuffersAreTextsOfBase64OrFiles) {
  const auto with = [](const std::string& uri) {
    std::string text = json({});
    return text.replace(text.find(R"("byteLength": 58)"), 16, R"("byteLength": 58, "uri": )" + uri);
  };
  expectRefused("a.gltf", {{with(R"("data:,abc")"), "buffers[0] is not valid base64"},
                           {with(R"("data:;base64,A")"), "buffers[0] is not valid base64"},
                           {with("7"), "buffers[0].uri is not a string"}});
}

TEST(ReadGltf, MessagesArePrintable) {
  try {
    readHere("{\"a\": \xD8\x01}", "a.gltf");
    FAIL();
  } catch (const Error& error) {
    for (const char c : std::string(error.what())) EXPECT_TRUE(c >= ' ' && c <= '~') << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
