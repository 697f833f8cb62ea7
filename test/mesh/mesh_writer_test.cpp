// Also tests src/mesh/ply_writer.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <locale>
#include <random>
#include <sstream>

#include "collision_hulls/mesh/mesh_io.h"
#include "files.h"

namespace collision_hulls {
namespace {

using test_files::TempFile;

ConvexHull tetrahedron(const Eigen::Vector3d& origin, double size) {
  ConvexHull hull;
  hull.vertices = {origin, origin + size * Eigen::Vector3d::UnitX(), origin + size * Eigen::Vector3d::UnitY(),
                   origin + size * Eigen::Vector3d::UnitZ()};
  hull.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return hull;
}

LoadedMesh readBack(const std::string& name, const std::string& bytes) {
  const TempFile file(name, bytes);
  return readMesh(file.path());
}

/// The corners of all triangles, one after another.
std::vector<Eigen::Vector3d> corners(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles) {
  std::vector<Eigen::Vector3d> result;
  for (const Triangle& t : triangles)
    for (const int v : t) result.push_back(vertices[static_cast<std::size_t>(v)]);
  return result;
}

/// A hull-like body with random single-precision vertices of sizes from `smallest` to `largest`.
ConvexHull randomBody(double smallest, double largest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(std::log(smallest), std::log(largest));
  ConvexHull hull = tetrahedron({0, 0, 0}, 1);
  for (Eigen::Vector3d& v : hull.vertices)
    for (int i = 0; i < 3; ++i) v[i] = static_cast<float>((random() % 2 ? 1 : -1) * std::exp(exponent(random)));
  return hull;
}

TEST(EncodeHull, StlHasTheRightSizeAndDoesNotBeginWithSolid) {
  const std::string bytes = encodeHull(tetrahedron({0, 0, 0}, 1), MeshFormat::kStl, "unused");
  ASSERT_EQ(84u + 4 * 50, bytes.size());
  EXPECT_NE("solid", bytes.substr(0, 5));
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  EXPECT_EQ(4u, count);
  float normal[3];
  std::memcpy(normal, bytes.data() + 84, sizeof normal);
  EXPECT_EQ(0, normal[0]);
  EXPECT_EQ(0, normal[1]);
  EXPECT_EQ(-1, normal[2]);
}

TEST(EncodeHull, ObjAsText) {
  EXPECT_EQ(
      "# convex hulls, metres, written by collision_hulls\n"
      "o arm_link_0\nv 0 0 0\nv 0.5 0 0\nv 0 0.5 0\nv 0 0 0.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
      encodeHull(tetrahedron({0, 0, 0}, 0.5), MeshFormat::kObj, "arm link\n0"));
}

TEST(EncodeHull, EveryFormatIsReadBackUnchanged) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const ConvexHull hull = randomBody(1e-6, 1e4, seed);
    const std::vector<Eigen::Vector3d> expected = corners(hull.vertices, hull.triangles);
    for (const MeshFormat format : {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kDae}) {
      const TriangleMesh mesh = readBack(std::string("hull") + extension(format), encodeHull(hull, format, "hull")).mesh;
      EXPECT_EQ(expected, corners(mesh.vertices, mesh.triangles)) << "seed " << seed << extension(format);
    }
  }
}

TEST(EncodeHull, DaeIsInMetresWithNamesValidInXml) {
  const std::string bytes = encodeHull(tetrahedron({0, 0, 0}, 0.5), MeshFormat::kDae, "arm \"<&>'");
  EXPECT_NE(std::string::npos, bytes.find("name=\"arm______\""));
  EXPECT_NE(std::string::npos, bytes.find("<unit name=\"meter\" meter=\"1\"/>"));
  EXPECT_NE(std::string::npos, bytes.find("count=\"12\">0 0 0 0.5 0 0 0 0.5 0 0 0 0.5 </float_array>"));
  EXPECT_NE(std::string::npos, bytes.find("<p>0 2 1 0 1 3 0 3 2 1 2 3 </p>"));
}

TEST(EncodePly, PartsAreReadBackInTheirOrder) {
  const ConvexHull body = tetrahedron({1, 2, 3}, 0.5);
  const TriangleMesh mesh{body.vertices, body.triangles};
  const std::string bytes = encodePly(mesh, {{1, 3}, {0}, {2}}, {Rgb{255, 0, 0}, Rgb{0, 255, 0}, Rgb{1, 2, 3}});
  const LoadedMesh back = readBack("parts.ply", bytes);
  const std::vector<Triangle> order{mesh.triangles[1], mesh.triangles[3], mesh.triangles[0], mesh.triangles[2]};
  EXPECT_EQ(corners(back.mesh.vertices, back.mesh.triangles), corners(mesh.vertices, order));
}

TEST(EncodePly, SharedVerticesAreWrittenOncePerPartInItsColour) {
  const ConvexHull body = tetrahedron({0, 0, 0}, 1);
  const std::string bytes = encodePly({body.vertices, body.triangles}, {{0, 1}, {2, 3}}, {Rgb{7, 8, 9}, Rgb{17, 18, 19}});
  EXPECT_NE(bytes.find("element vertex 8\n"), std::string::npos) << bytes.substr(0, 400);
  const std::size_t start = bytes.find("end_header\n") + 11, vertex = 3 * 4 + 3, face = 1 + 4 * 4;
  ASSERT_EQ(bytes.size(), start + 8 * vertex + 4 * face);
  EXPECT_EQ(bytes.substr(start + 12, 3), "\x07\x08\x09");
  EXPECT_EQ(bytes.substr(start + 4 * vertex + 12, 3), "\x11\x12\x13");
  EXPECT_EQ(bytes.substr(bytes.size() - 4, 1), "\x01");  // the last face's part
}

TEST(EncodePly, RefusesIndicesOutOfRange) {
  const ConvexHull body = tetrahedron({0, 0, 0}, 1);
  const TriangleMesh mesh{body.vertices, body.triangles};
  TriangleMesh wrong = mesh;
  wrong.triangles[0][0] = 4;
  const std::vector<Rgb> colours{Rgb{1, 2, 3}};
  EXPECT_THROW(encodePly(wrong, {{0}}, colours), Error);
  for (const int triangle : {-1, 4}) EXPECT_THROW(encodePly(mesh, {{triangle}}, colours), Error);
  EXPECT_THROW(encodePly(mesh, {{0}, {1}}, colours), Error);
}

TEST(MeshFormat, Names) {
  for (const MeshFormat format : {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kDae})
    EXPECT_EQ(format, meshFormatNamed(extension(format) + 1));
  for (const char* name : {"", "ply", ".stl", "STL"}) EXPECT_FALSE(meshFormatNamed(name)) << name;
}

TEST(EncodeHull, ObjPreservesNumbersOfAnySize) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const ConvexHull hull = randomBody(1e-37, 1e37, seed);
    std::istringstream text(encodeHull(hull, MeshFormat::kObj, "hull"));
    std::size_t v = 0;
    for (std::string word; text >> word;)
      if (word == "v") {
        for (int i = 0; i < 3; ++i) {
          text >> word;
          EXPECT_EQ(static_cast<float>(hull.vertices[v][i]), std::strtof(word.c_str(), nullptr)) << word << ", seed " << seed;
        }
        ++v;
      }
    EXPECT_EQ(hull.vertices.size(), v);
  }
}

TEST(EncodeHull, VertexNumbersContinueAcrossObjectsOfAFile) {
  const std::vector<ConvexHull> hulls{tetrahedron({0, 0, 0}, 1), tetrahedron({2, 0, 0}, 1)};
  const std::string text = encodeHullsObj(hulls, "arm");
  EXPECT_NE(std::string::npos, text.find("o arm_0\n"));
  EXPECT_NE(std::string::npos, text.find("o arm_1\n"));
  const LoadedMesh loaded = readBack("arm_hulls.obj", text);
  EXPECT_EQ(2, loaded.submeshes);
  std::vector<Eigen::Vector3d> expected = corners(hulls[0].vertices, hulls[0].triangles);
  const std::vector<Eigen::Vector3d> second = corners(hulls[1].vertices, hulls[1].triangles);
  expected.insert(expected.end(), second.begin(), second.end());
  EXPECT_EQ(expected, corners(loaded.mesh.vertices, loaded.mesh.triangles));
}

TEST(EncodeHull, IgnoresTheLocale) {
  const ConvexHull hull = tetrahedron({0.5, 0, 0}, 12345);
  const std::string before = encodeHull(hull, MeshFormat::kObj, "hull");
  struct German : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new German));
  EXPECT_EQ(before, encodeHull(hull, MeshFormat::kObj, "hull"));
  std::locale::global(old);
}

}  // namespace
}  // namespace collision_hulls
