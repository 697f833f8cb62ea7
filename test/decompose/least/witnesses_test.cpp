#include "decompose/least/witnesses.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

TEST(SurfacePoints, AllVerticesOfASmallMeshEachOnce) {
  TriangleMesh twice = box(1, 2, 3);
  twice = merged({twice, twice});
  const SurfacePoints points = surfacePoints(twice, 100);
  EXPECT_EQ(points.vertices, 8u);
  EXPECT_NEAR(static_cast<double>(points.all.size()), 108, 2);
}

TEST(SurfacePoints, LieOnTheSurface) {
  const TriangleMesh mesh = torus();
  const Solid solid = solidOf(mesh);
  const SurfacePoints points = surfacePoints(mesh, 100);
  EXPECT_LE(points.vertices, 100u);
  EXPECT_GT(points.vertices, 50u);
  for (const Eigen::Vector3d& p : points.all) EXPECT_LE(solid.distanceToSurface(p), 1e-12);
}

TEST(SurfacePoints, OfTrianglesWithoutArea) {
  TriangleMesh mesh = singleTriangle();
  mesh.vertices.assign(3, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(surfacePoints(mesh, 10).all.size(), 1u);
}

TEST(OwnPoints, AreFurthestFromAllOtherHulls) {
  const Points points{{0.5, 0, 0}, {0.1, 0, 0}, {1.5, 0, 0}, {2.9, 0, 0}, {2.5, 0, 0}};
  const std::vector<ConvexHull> hulls{boxHull({0, -1, -1}, {1.6, 1, 1}), boxHull({1.4, -1, -1}, {3, 1, 1})};
  const Points own = ownPoints(points, hulls);
  ASSERT_EQ(own.size(), 2u);
  EXPECT_EQ(own[0], points[1]);
  EXPECT_EQ(own[1], points[3]);
  EXPECT_TRUE(ownPoints({points[2]}, hulls).empty());
  EXPECT_TRUE(ownPoints(points, {}).empty());
  EXPECT_TRUE(ownPoints(points, {hulls[0]}).empty());
}

TEST(SpreadOf, KeepsThoseThatAreFarApart) {
  const Points points{{0, 0, 0}, {0.1, 0, 0}, {5, 0, 0}, {5.1, 0, 0}, {2, 0, 0}, {5.1, 0, 0}};
  EXPECT_EQ(spreadOf(points, 3), (Points{points[0], points[3], points[4]}));
  EXPECT_EQ(spreadOf(points, 6), points);
  EXPECT_EQ(spreadOf(points, 5).size(), 5u);  // one place is there twice
}

TEST(AddSpread, EndsOfABarComeFirst) {
  const SurfacePoints points = surfacePoints(box(10, 1, 1), 50);
  Points chosen{Eigen::Vector3d(5, 0.5, 1)};
  addSpread(points, 2, chosen);
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_NEAR(std::abs(chosen[1].x() - chosen[2].x()), 10, 0.5);
  addSpread(points, 1'000, chosen);
  EXPECT_EQ(chosen.size(), points.all.size() + 1);  // each once
}

}  // namespace
}  // namespace collision_hulls
