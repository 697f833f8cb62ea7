#include "decompose/bounding_box.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;
using Eigen::Vector3d;

TEST(OrientedBox, FindsABoxHoweverItIsTurned) {
  RandomPoints random(11);
  for (int i = 0; i < 20; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = random.rotation();
    pose.translation() = random.inCube();
    const ConvexHull box = orientedBox(transformed(boxHull({0, 0, 0}, {1, 0.5, 0.2}), pose));
    EXPECT_EQ(box.vertices.size(), 8u);
    EXPECT_NEAR(volume(box), 0.1, 1e-9);
  }
}

TEST(OrientedBox, HoldsTheHullAndIsNoLargerThanTheBoxAlongTheAxes) {
  RandomPoints random(12);
  for (int i = 0; i < 20; ++i) {
    const ConvexHull hull = convexHull(random.cloud(30));
    const ConvexHull box = orientedBox(hull);
    for (const Vector3d& v : hull.vertices) EXPECT_LE(planeDistance(box, v), 0);
    EXPECT_LE(volume(box), boundingBox(hull).volume() * (1 + 1e-9));
  }
}

TEST(OrientedBox, HoldsAHullThatIsHardlyLargerThanRounding) {
  RandomPoints random(14);
  for (const double size : {1e-15, 1e-13, 1e-11, 1e-9}) {
    for (int i = 0; i < 20; ++i) {
      const Vector3d where = random.inCube();
      std::vector<Vector3d> points = random.cloud(3);
      for (Vector3d& p : points) p = where + size * p;
      const ConvexHull hull = convexHull(points), box = orientedBox(hull);
      for (const Vector3d& v : hull.vertices) EXPECT_LE(planeDistance(box, v), 0) << size;
    }
  }
}

TEST(PrincipalAxes, TheFirstHasTheLeastSpread) {
  RandomPoints random(13);
  std::vector<Vector3d> points = random.cloud(500);
  for (Vector3d& p : points) p = p.cwiseProduct(Vector3d(1, 0.1, 3));
  const Eigen::Matrix3d axes = principalAxes(points);
  EXPECT_GT(std::abs(axes.col(0).y()), 0.99);
  EXPECT_GT(std::abs(axes.col(2).z()), 0.99);
}

TEST(HullHolding, GrowsByRoundingAlone) {
  const std::vector<Vector3d> corners = box(1, 1, 1).vertices;
  const auto grown = hullHolding(corners, {{0.5, 0.5, 1 + 1e-14}});
  ASSERT_TRUE(grown);
  EXPECT_LE(planeDistance(*grown, {0.5, 0.5, 1 + 1e-14}), 0);
  EXPECT_FALSE(hullHolding(corners, {{0.5, 0.5, 1.01}}));
}

}  // namespace
}  // namespace collision_hulls
