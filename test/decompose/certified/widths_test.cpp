#include "decompose/certified/widths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

Widths widthsOf(const std::vector<Vector3d>& points) {
  Widths widths;
  for (const Vector3d& p : points) widths.extend(p);
  return widths;
}

Vector3d nearestOn(const TriangleMesh& mesh, const Vector3d& p) {
  return TriangleBvh(mesh).nearest(p).point;
}

/// An upper bound on the distance between two disjoint hulls, by alternating projections.
double distanceBetween(const ConvexHull& a, const ConvexHull& b) {
  const TriangleMesh on_a = surface(a), on_b = surface(b);
  Vector3d p = on_a.vertices.front(), q = p;
  for (int i = 0; i < 50; ++i) {
    q = nearestOn(on_b, p);
    p = nearestOn(on_a, q);
  }
  return (p - q).norm();
}

TEST(Widths, AnythingContainsTheEmptySet) {
  const Widths nothing, point = widthsOf({{1, 2, 3}});
  EXPECT_TRUE(point.contains(nothing));
  EXPECT_FALSE(nothing.contains(point));
  EXPECT_EQ(nothing.merged(point).mean(), 0);
}

TEST(Widths, APointHasWidthZero) {
  const Widths point = widthsOf({{1, 2, 3}});
  EXPECT_EQ(point.mean(), 0);
  EXPECT_EQ(point.middle(0), 1);
  EXPECT_EQ(point.middle(1), 2);
  EXPECT_EQ(point.middle(2), 3);
  EXPECT_EQ(point.gap(point), 0);
  EXPECT_TRUE(point.contains(point));
}

TEST(Widths, MeanOfTheUnitCube) {
  const Widths cube = widthsOf(test_shapes::box(1, 1, 1).vertices);
  EXPECT_NEAR(cube.mean(), (3 + 6 * std::sqrt(2.0) + 4 * std::sqrt(3.0)) / 13, 1e-12);
}

TEST(Widths, GapAlongEachKindOfDiagonal) {
  const std::vector<Vector3d> cube = test_shapes::box(1, 1, 1).vertices;
  for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(0, -1, 1), Vector3d(1, 1, -1)}) {
    std::vector<Vector3d> away = cube;
    for (Vector3d& p : away) p += 3 * way;
    EXPECT_NEAR(widthsOf(cube).gap(widthsOf(away)), 2 * way.norm(), 1e-12) << way.transpose();
    EXPECT_NEAR(widthsOf(away).gap(widthsOf(cube)), 2 * way.norm(), 1e-12) << way.transpose();
  }
}

TEST(Widths, GapIsALowerBoundOfTheDistance) {
  const unsigned seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  RandomPoints random(seed);
  int apart = 0;
  for (int i = 0; i < 100; ++i) {
    const Vector3d away = random.number(0, 4) * random.onSphere();
    std::vector<Vector3d> a = random.cloud(12), b = random.cloud(12);
    for (Vector3d& p : b) p += away;
    const double gap = widthsOf(a).gap(widthsOf(b));
    EXPECT_GE(gap, 0);
    if (gap == 0) continue;
    ++apart;
    const double least = distanceBetween(convexHull(a), convexHull(b));
    EXPECT_LE(gap, least + 1e-9) << "pair " << i;
  }
  EXPECT_GT(apart, 30);
}

TEST(Widths, GapOfBallsIsCloseToTheDistance) {
  RandomPoints random(8);
  const TriangleMesh ball = test_shapes::sphere(1, 6);
  for (int i = 0; i < 50; ++i) {
    const Vector3d away = 10 * random.onSphere();
    const double gap = widthsOf(ball.vertices).gap(widthsOf(test_shapes::moved(ball, away).vertices));
    EXPECT_GT(gap, 0.85 * 8);
    EXPECT_LE(gap, 8.1);  // the ball's faces lie inside it
  }
}

TEST(Widths, MergedAreThoseOfTheUnion) {
  RandomPoints random(9);
  const std::vector<Vector3d> a = random.cloud(10), b = random.cloud(10, 2);
  std::vector<Vector3d> both = a;
  both.insert(both.end(), b.begin(), b.end());
  const Widths merged = widthsOf(a).merged(widthsOf(b));
  EXPECT_EQ(merged.mean(), widthsOf(both).mean());
  for (int d = 0; d < Widths::kDirections; ++d) EXPECT_EQ(merged.middle(d), widthsOf(both).middle(d));
  EXPECT_TRUE(merged.contains(widthsOf(a)) && merged.contains(widthsOf(b)));
  EXPECT_FALSE(widthsOf(a).contains(merged));
}

TEST(Widths, MeanHardlyDependsOnRotation) {
  RandomPoints random(10);
  const std::vector<Vector3d> rod{{0, 0, 0}, {1, 0, 0}};
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d turn = random.rotation();
    const Widths turned = widthsOf({turn * rod[0], turn * rod[1]});
    EXPECT_NEAR(turned.mean(), 0.5, 0.05);  // the mean of |cosine| over the sphere
  }
}

}  // namespace
}  // namespace collision_hulls
