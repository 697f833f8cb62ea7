#include "decompose/surface_piece.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "shapes.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

TEST(SurfacePiece, PartsAtAPlaneMakeUpTheWhole) {
  const SurfacePiece piece = torus();
  const HalfSpace plane{Eigen::Vector3d(1, 2, 0.5).normalized(), 0.1};
  const std::vector<SurfacePiece> parts = parted(piece, plane, 1e-9);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(area(parts[0]) + area(parts[1]), area(piece), 1e-9);
  for (const Eigen::Vector3d& v : parts[0].vertices) EXPECT_LE(plane.distance(v), 1e-9);
  for (const Eigen::Vector3d& v : parts[1].vertices) EXPECT_GE(plane.distance(v), -1e-9);
  EXPECT_EQ(parted(piece, {plane.normal, 10}, 1e-9).size(), 1u) << "a plane that divides nothing";
}

TEST(SurfacePiece, TheMiddlePlaneDividesTheLongestSide) {
  const HalfSpace plane = middlePlane(box(1, 4, 2));
  EXPECT_NEAR(std::abs(plane.normal.y()), 1, 1e-12);
  EXPECT_NEAR(plane.distance({0, 2, 0}), 0, 1e-12);
}

TEST(SurfacePiece, ComponentsShareNoVertex) {
  const std::vector<SurfacePiece> parts = components(merged({box(1, 1, 1), moved(box(1, 1, 1), {2, 0, 0}), torus()}));
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].vertices.size(), 8u);
  EXPECT_NEAR(boundingBox(parts[1]).min().x(), 2, 1e-12);
}

TEST(SurfacePiece, ASimplifiedOneStaysInItsBox) {
  const SurfacePiece piece = sphere(1, 8);
  const SurfacePiece simple = simplified(piece, 60);
  EXPECT_LE(simple.vertices.size(), 60u);
  EXPECT_GE(simple.vertices.size(), 10u);
  EXPECT_TRUE(boundingBox(piece).contains(boundingBox(simple)));
}

// Such vertices took the cells of others, which then moved there.
TEST(SurfacePiece, VerticesOfNoTriangleMoveNoOther) {
  SurfacePiece piece = test_shapes::torus(0.1, 0.03, 32, 16);
  const Eigen::AlignedBox3d box = boundingBox(piece);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& far :
       {Eigen::Vector3d(1e30, 0, 0), Eigen::Vector3d(1e300, 1e300, 1e300), Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(nan, nan, nan)}) {
    piece.vertices.insert(piece.vertices.begin(), far);
    for (Triangle& t : piece.triangles)
      for (int& v : t) ++v;
  }
  const SurfacePiece simple = simplified(piece, 60);
  EXPECT_FALSE(simple.triangles.empty());
  EXPECT_TRUE(box.contains(boundingBox(simple)));
}

TEST(SurfacePiece, EachEdgeOnce) {
  const auto edges = edgesOf(box(1, 1, 1));
  EXPECT_EQ(edges.size(), 18u) << "twelve sides and six diagonals";
  EXPECT_EQ((std::set<std::pair<int, int>>(edges.begin(), edges.end()).size()), 18u);
  for (const auto& [a, b] : edges) EXPECT_LT(a, b);
}

}  // namespace
}  // namespace collision_hulls
