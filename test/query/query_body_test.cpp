#include "collision_hulls/query/query_body.h"

#include <gtest/gtest.h>

#include "counted_looks.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;
using Eigen::Vector3d;

Eigen::Isometry3d at(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

TEST(QueryBody, HullsApartInContactAndOverlapping) {
  for (const double side : {1.0, 1e-3}) {
    const QueryBody cube(boxHull(Vector3d::Zero(), Vector3d::Constant(side)));
    EXPECT_EQ(cube.corners(), 8u);
    EXPECT_FALSE(touch(cube, cube, at(1.01 * side, 0, 0)));
    EXPECT_TRUE(touch(cube, cube, at(0.99 * side, 0.1 * side, 0)));
    EXPECT_NEAR(distanceBelow(1, cube, cube, at(1.5 * side, 0.2 * side, 0.1 * side)), 0.5 * side, 1e-6 * side);
    EXPECT_EQ(distanceBelow(1, cube, cube, at(0.5 * side, 0, 0)), 0);
  }
}

TEST(QueryBody, AShapeStandsAtItsOrigin) {
  const QueryBody cube(boxHull(Vector3d::Zero(), Vector3d::Ones()));
  const QueryBody ball({QueryShape::Kind::kSphere, Vector3d(0.25, 0, 0)}, at(2, 0.5, 0.5));
  EXPECT_FALSE(touch(cube, ball, Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(touch(cube, ball, at(-0.8, 0, 0)));
  EXPECT_LT((ball.box().min() - Vector3d(1.75, 0.25, 0.25)).norm(), 1e-12);
  EXPECT_EQ(ball.corners(), 0u);
}

TEST(QueryBody, IsCancelledWhileFclBuildsItsTree) {
  const TriangleMesh mesh = sphere(1, 16);
  const std::size_t nodes = 2 * mesh.triangles.size() - 1;
  const auto build = [&](const RunControl& control) { const QueryBody body(mesh, control); };
  EXPECT_GE(looksOf(build), nodes);
  EXPECT_EQ(looksAfterCancel(nodes / 2, build), 1u);
}

TEST(QueryBody, AMeshWithoutAreaIsEmptyAndTouchesNothing) {
  TriangleMesh line;
  line.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  const QueryBody none(line), cube(boxHull(Vector3d::Zero(), Vector3d::Ones()));
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(touch(none, cube, Eigen::Isometry3d::Identity()));
  EXPECT_EQ(distanceBelow(0.7, none, cube, Eigen::Isometry3d::Identity()), 0.7);
}

TEST(QueryBody, AHullWithoutVerticesIsEmpty) {
  const QueryBody none{ConvexHull()};
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(touch(none, QueryBody(boxHull(Vector3d::Zero(), Vector3d::Ones())), Eigen::Isometry3d::Identity()));
}

TEST(Apart, AgreesWithTheBoxesHulls) {
  RandomPoints random(7);
  int separated = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::AlignedBox3d a(Vector3d::Zero(), Vector3d::Ones() + random.inCube());
    const Eigen::AlignedBox3d b(Vector3d::Zero(), Vector3d::Ones() * 0.6);
    Eigen::Isometry3d pose = at(0, 0, 0);
    pose.linear() = Eigen::AngleAxisd(3 * random.inCube().x(), random.inCube().normalized()).toRotationMatrix();
    pose.translation() = 2 * random.inCube();
    const bool touching = touch(QueryBody(boxHull(a.min(), a.max())), QueryBody(boxHull(b.min(), b.max())), pose);
    EXPECT_NE(apart(a, b, pose), touching) << i;
    separated += !touching;
  }
  EXPECT_GT(separated, 50);
  EXPECT_LT(separated, 475);
}

}  // namespace
}  // namespace collision_hulls
