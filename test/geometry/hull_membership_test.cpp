#include "geometry/hull_membership.h"

#include <gtest/gtest.h>

#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> ball(std::size_t count, const Vector3d& axes, std::uint32_t seed) {
  test_shapes::RandomPoints random(seed);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(axes.cwiseProduct(random.onSphere()));
  return points;
}

/// Agrees with the hull about random points, unless these are next to its surface.
void expectAsHull(const std::vector<Vector3d>& points, std::uint32_t seed) {
  const ConvexHull hull = convexHull(points);
  const Eigen::AlignedBox3d box = boundingBox(hull);
  const double margin = 1e-9 * box.sizes().maxCoeff();
  HullMembership membership(points);
  test_shapes::RandomPoints random(seed);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = random.inBox(box);
    const double distance = planeDistance(hull, p);
    if (std::abs(distance) < margin) continue;
    ASSERT_EQ(membership.holds(p), distance < 0) << p.transpose() << ", " << distance;
    inside += distance < 0;
  }
  EXPECT_GT(inside, 100);
}

TEST(HullMembership, AgreesWithTheHull) {
  expectAsHull(test_shapes::box(1, 2, 3).vertices, 1);
  expectAsHull(ball(500, {1, 1, 1}, 2), 3);
  expectAsHull(ball(40, {1, 0.3, 0.05}, 4), 5);
  for (std::uint32_t seed = 10; seed < 60; ++seed) expectAsHull(test_shapes::RandomPoints(seed).cloud(8), seed);
}

TEST(HullMembership, AgreesWithTheHullFarAwayAndAtAnySize) {
  for (const double size : {1e-6, 1e6}) {
    std::vector<Vector3d> points = ball(100, Vector3d::Constant(size), 7);
    for (Vector3d& p : points) p += size * Vector3d(300, -200, 100);
    expectAsHull(points, 8);
  }
}

TEST(HullMembership, WhatIsOnTheSurfaceOrOutsideIsNotHeld) {
  const std::vector<Vector3d> points = test_shapes::box(1, 1, 1).vertices;
  HullMembership box(points);
  EXPECT_TRUE(box.holds({0.5, 0.5, 1 - 1e-6}));
  EXPECT_FALSE(box.holds({0.5, 0.5, 1}));
  EXPECT_FALSE(box.holds({0.5, 0.5, 1 + 1e-6}));
  for (const Vector3d& corner : points) EXPECT_FALSE(box.holds(corner));
}

TEST(HullMembership, FlatSetsHoldNothing) {
  const std::vector<Vector3d> sheet{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Eigen::AngleAxisd turn(0.7, Vector3d(1, 2, 3).normalized());
  std::vector<Vector3d> turned;
  for (const Vector3d& p : sheet) turned.push_back(turn * p);
  for (const double height : {0.0, 1e-3, -0.2}) {
    EXPECT_FALSE(HullMembership(sheet).holds({0.4, 0.4, height}));
    EXPECT_FALSE(HullMembership(turned).holds(turn * Vector3d(0.4, 0.4, height)));
  }
  EXPECT_FALSE(HullMembership({{1, 2, 3}}).holds({1, 2, 3}));
}

}  // namespace
}  // namespace collision_hulls
