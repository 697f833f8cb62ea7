#include "web/drawn_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "shapes.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kAll = 1000000;

Eigen::Vector3d place(const DrawnMesh& mesh, int vertex) {
  const auto& p = mesh.vertices[static_cast<std::size_t>(vertex)];
  return mesh.origin + mesh.step * Eigen::Vector3d(p[0], p[1], p[2]);
}

TriangleMesh toMesh(const DrawnMesh& drawn) {
  TriangleMesh mesh;
  for (int v = 0; v < static_cast<int>(drawn.vertices.size()); ++v) mesh.vertices.push_back(place(drawn, v));
  mesh.triangles = drawn.triangles;
  return mesh;
}

TEST(DrawnMesh, ASmallMeshIsAllThere) {
  const TriangleMesh box = test_shapes::box(1, 2, 3, 4);
  const DrawnMesh drawn = drawnMesh(box, kAll);
  EXPECT_EQ(drawn.triangles.size(), box.triangles.size());
  EXPECT_EQ(drawn.vertices.size(), box.vertices.size());
  EXPECT_NEAR(signedVolume(toMesh(drawn)), 6, 6e-4);
  EXPECT_EQ(drawn.step, 3.0 / 65535);
}

TEST(DrawnMesh, VerticesAreWithinHalfACell) {
  const TriangleMesh box = test_shapes::box(1, 2, 3, 3);
  const DrawnMesh drawn = drawnMesh(box, kAll);
  for (const Eigen::Vector3d& vertex : box.vertices) {
    double least = 1;
    for (int v = 0; v < static_cast<int>(drawn.vertices.size()); ++v)
      least = std::min(least, (place(drawn, v) - vertex).lpNorm<Eigen::Infinity>());
    EXPECT_LE(least, 0.5001 * drawn.step);
  }
}

TEST(DrawnMesh, ALargeMeshIsThinnedAndKeepsItsShape) {
  const TriangleMesh box = test_shapes::box(1, 2, 3, 40);
  ASSERT_GT(box.triangles.size(), 19000u);
  const DrawnMesh drawn = drawnMesh(box, 2000);
  EXPECT_LE(drawn.triangles.size(), 2000u);
  EXPECT_GE(drawn.triangles.size(), 500u);
  EXPECT_NEAR(area(toMesh(drawn)), 22, 1.5);
  for (const Triangle& t : drawn.triangles) EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
}

/// It would look as if hulls did not cover it.
TEST(DrawnMesh, AThinnedMeshStaysWithinItsHull) {
  const DrawnMesh drawn = drawnMesh(test_shapes::sphere(1, 60), 2000);
  EXPECT_LE(drawn.triangles.size(), 2000u);
  for (int v = 0; v < static_cast<int>(drawn.vertices.size()); ++v) {
    EXPECT_LE(place(drawn, v).norm(), 1.0001);
    EXPECT_GE(place(drawn, v).norm(), 0.98);
  }
}

TEST(DrawnMesh, WhatIsNoTriangleIsLeftOut) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  const std::size_t good = mesh.triangles.size();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& bad : {Eigen::Vector3d(nan, 0, 0), Eigen::Vector3d(0, INFINITY, 0), Eigen::Vector3d(0, 0, 1e300)}) {
    mesh.vertices.push_back(bad);
    mesh.triangles.push_back({0, 1, static_cast<int>(mesh.vertices.size()) - 1});
  }
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.push_back({0, -1, 2});
  mesh.triangles.push_back({0, 1, 1000});
  const DrawnMesh drawn = drawnMesh(mesh, kAll);
  EXPECT_EQ(drawn.triangles.size(), good);
  EXPECT_EQ(drawn.vertices.size(), 8u);
}

TEST(DrawnMesh, NothingToDraw) {
  TriangleMesh point;
  point.vertices = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  point.triangles = {{0, 1, 2}};
  for (const TriangleMesh& mesh : {TriangleMesh(), point}) {
    EXPECT_TRUE(drawnMesh(mesh, kAll).triangles.empty());
    EXPECT_TRUE(drawnMesh(mesh, 0).triangles.empty());
    EXPECT_EQ(toPageBytes(drawnMesh(mesh, kAll)), "");
  }
}

TEST(DrawnMesh, ManyTrianglesInAPlaneEndToo) {
  TriangleMesh strip;
  for (int i = 0; i < 3000; ++i) strip.vertices.emplace_back(i * 1e-3, i % 2, 0);
  for (int i = 0; i + 2 < 3000; ++i) strip.triangles.push_back({i, i + 1, i + 2});
  EXPECT_LE(drawnMesh(strip, 10).triangles.size(), 10u);
}

TEST(ToPageBytes, VerticesThenTrianglesAligned) {
  const DrawnMesh drawn = drawnMesh(test_shapes::box(1, 1, 1), kAll);
  const std::string bytes = toPageBytes(drawn);
  ASSERT_EQ(bytes.size(), 8u * 6 + 12 * 3);
  std::uint16_t x = 0;
  std::memcpy(&x, bytes.data() + 6 * 7, sizeof x);
  EXPECT_EQ(x, drawn.vertices[7][0]);
  EXPECT_EQ(static_cast<int>(static_cast<unsigned char>(bytes[48 + 3 * 5 + 1])), drawn.triangles[5][1]);
}

TEST(IndexBytes, AsManyAsNeeded) {
  EXPECT_EQ(indexBytes(256), 1);
  EXPECT_EQ(indexBytes(257), 2);
  EXPECT_EQ(indexBytes(65536), 2);
  EXPECT_EQ(indexBytes(65537), 4);
}

TEST(ToPageBytes, WiderIndices) {
  const DrawnMesh drawn = drawnMesh(test_shapes::box(1, 1, 1, 10), kAll);
  ASSERT_GT(drawn.vertices.size(), 256u);
  EXPECT_EQ(toPageBytes(drawn).size(), (6 * drawn.vertices.size() + 3) / 4 * 4 + (6 * drawn.triangles.size() + 3) / 4 * 4);
}

}  // namespace
}  // namespace collision_hulls
