#include "mesh/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace collision_hulls {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

Eigen::Vector3d normalOf(const Polygon& p, const Triangle& t) {
  const auto at = [&](int k) { return p[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
  return (at(1) - at(0)).cross(at(2) - at(0));
}

/// Expects n - 2 triangles that use every corner, run in the polygon's direction and have its area.
void expectTriangulation(const Polygon& polygon, double area) {
  const std::vector<Triangle> triangles = triangulate(polygon);
  EXPECT_EQ(polygon.size() - 2, triangles.size());
  std::set<int> used;
  double sum = 0;
  for (const Triangle& t : triangles) {
    used.insert(t.begin(), t.end());
    EXPECT_GE(normalOf(polygon, t).z(), 0);
    sum += normalOf(polygon, t).z() / 2;
  }
  EXPECT_EQ(polygon.size(), used.size());
  EXPECT_NEAR(area, sum, 1e-12 * area);
}

TEST(Triangulate, PolygonWithoutAreaUsesEveryCorner) {
  EXPECT_EQ(3u, triangulate(Polygon(5, Eigen::Vector3d(1, 2, 3))).size());
  EXPECT_EQ(2u, triangulate({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size());
}

TEST(Triangulate, SelfIntersectingPolygonUsesEveryCorner) {
  const Polygon bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  std::set<int> used;
  for (const Triangle& t : triangulate(bow)) used.insert(t.begin(), t.end());
  EXPECT_EQ(4u, used.size());
}

TEST(Triangulate, ConvexAndConcaveShapes) {
  expectTriangulation({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0.5);
  expectTriangulation({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 2);
  expectTriangulation({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, 4);                                              // arrow head
  expectTriangulation({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 7);  // U
  expectTriangulation({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}}, 2);  // corners along its sides
}

TEST(Triangulate, RandomStars) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.1, 1);
  for (int n = 4; n < 60; ++n) {
    Polygon star;
    double area = 0;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * M_PI * i / n, r = radius(random);
      star.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
      if (i > 0) area += star[star.size() - 2].cross(star.back()).z() / 2;
    }
    area += star.back().cross(star.front()).z() / 2;
    expectTriangulation(star, area);
  }
}

TEST(OtherReading, IsNoneForFlatPolygons) {
  for (const Polygon& flat : {Polygon{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}},        // convex
                              Polygon{{4, 0, 0}, {1, 1, 0}, {0, 4, 0}, {0, 0, 0}},        // concave, and no fan from its first corner
                              Polygon{{4, 0, 1e-9}, {1, 1, 0}, {0, 4, 1e-9}, {0, 0, 0}},  // so but for rounding
                              Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}})       // without area
    EXPECT_TRUE(otherReading(flat, triangulate(flat)).empty());
}

TEST(OtherReading, IsTheFanWhereTheSurfaceIsInDoubt) {
  const Polygon fan{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};  // not flat, but our own reading is the fan
  EXPECT_TRUE(otherReading(fan, triangulate(fan)).empty());
  const Polygon bent{{4, 0, 1}, {1, 1, 0}, {0, 4, 1}, {0, 0, 0}};
  EXPECT_EQ(otherReading(bent, triangulate(bent)), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  const Polygon crossed{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  std::set<Triangle> readings{{0, 1, 2}, {0, 2, 3}};
  for (const Triangle& t : triangulate(crossed)) readings.erase(t);
  const std::vector<Triangle> other = otherReading(crossed, triangulate(crossed));
  EXPECT_EQ(std::set<Triangle>(other.begin(), other.end()), readings);
}

}  // namespace
}  // namespace collision_hulls
