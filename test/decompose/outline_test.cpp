#include "decompose/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector2d;
using test_shapes::kPi;
using test_shapes::RandomPoints;

Outline polygon(int corners) {
  Outline result;
  for (int i = 0; i < corners; ++i) result.emplace_back(std::cos(2 * kPi * i / corners), std::sin(2 * kPi * i / corners));
  return result;
}

double areaOf(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// The least distance of a point from the lines through an outline's edges, on their inner side.
double depthIn(const Outline& outline, const Vector2d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &a = outline[i], edge = outline[(i + 1) % outline.size()] - a, way = p - a;
    least = std::min(least, (edge.x() * way.y() - edge.y() * way.x()) / edge.norm());
  }
  return least;
}

TEST(Outline, CollinearPoints) {
  EXPECT_EQ(outlineOf({{0, 0}, {2, 2}, {1, 1}}).size(), 2u);
}

TEST(Outline, IsCounterClockwiseWithCornersOnly) {
  const Outline square = outlineOf({{1, 1}, {0, 0}, {0.5, 0.5}, {0, 1}, {1, 0}, {0.5, 0}});
  EXPECT_EQ(square.size(), 4u);
  EXPECT_EQ(areaOf(square), 1);
}

TEST(Outline, FewEnoughCornersAreKept) {
  EXPECT_EQ(simplified(polygon(6), 6), polygon(6));
}

/// Dropping every second edge would be best; where the two ways around meet, two neighbours are dropped.
TEST(Outline, HalfOfARegularPolygonsEdges) {
  const Outline half = simplified(polygon(62), 31);
  EXPECT_EQ(half.size(), 31u);
  for (const Vector2d& p : half) EXPECT_LE(p.norm(), (1 + 1e-9) / std::cos(1.5 * kPi / 31));
}

TEST(Outline, ContainsTheOutlineItSimplifies) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    std::vector<Vector2d> points;
    for (int i = 0; i < 60; ++i)
      points.push_back(random.inCube().head<2>().cwiseProduct(Vector2d(1, std::pow(10.0, -static_cast<double>(seed % 4)))));
    const Outline outline = outlineOf(points);
    for (std::size_t most : {4u, 5u, 8u}) {
      const Outline less = simplified(outline, most);
      EXPECT_LE(less.size(), std::max<std::size_t>(most, 4));
      for (const Vector2d& p : points) EXPECT_GE(depthIn(less, p), -1e-12);
    }
  }
}

TEST(Prism, AroundABoxIsTheBox) {
  const ConvexHull box = test_shapes::boxHull({0, 0, 0}, {3, 2, 0.1});
  EXPECT_NEAR(volume(prismAbout(box, 8)), volume(box), 1e-12);
}

TEST(Prism, AroundABallUsesAllAllowedCorners) {
  const ConvexHull ball = test_shapes::hullOf(test_shapes::sphere(1, 6));
  for (int most : {8, 9, 16}) {
    const ConvexHull prism = prismAbout(ball, most);
    EXPECT_EQ(prism.vertices.size(), static_cast<std::size_t>(most) / 2 * 2);
    for (const Eigen::Vector3d& v : ball.vertices) EXPECT_LE(planeDistance(prism, v), 1e-9);
  }
}

}  // namespace
}  // namespace collision_hulls
