#include "measure/triangle_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

/// Two triangles of a mesh of size 1.
bool areNeighbours(const std::vector<Vector3d>& vertices, const Triangle& t, const Triangle& u) {
  const bool answer = meetOnlyAsNeighbours({vertices, {t, u}}, 0, 1, 1);
  EXPECT_EQ(answer, meetOnlyAsNeighbours({vertices, {u, t}}, 0, 1, 1)) << "the order does not matter";
  return answer;
}

TEST(TrianglePairs, WithoutCommonCorners) {
  const auto pair = [](const std::array<Vector3d, 3>& u) {
    return areNeighbours({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, u[0], u[1], u[2]}, {0, 1, 2}, {3, 4, 5});
  };
  EXPECT_TRUE(pair({{{0, 0, 1e-9}, {1, 0, 1e-9}, {0, 1, 1e-9}}})) << "above";
  EXPECT_FALSE(pair({{{0.2, 0.2, 0}, {1, 0, 1}, {0, 1, 1}}})) << "a corner on the other's face";
  EXPECT_FALSE(pair({{{0.2, 0.2, 1e-14}, {1, 0, 1}, {0, 1, 1}}})) << "too near to tell";
  EXPECT_FALSE(pair({{{0.2, 0.2, -1}, {0.2, 0.2, 1}, {2, 2, 0}}})) << "through";
  EXPECT_FALSE(pair({{{0.5, -1, -1}, {0.5, -1, 1}, {0.5, 1, 0}}})) << "edge against edge";
  EXPECT_TRUE(pair({{{0.6, 0.6, 0}, {1, 1, 0}, {1, 0.6, 0}}})) << "apart in one plane";
  EXPECT_FALSE(pair({{{0.4, 0.4, 0}, {1, 1, 0}, {1, 0.6, 0}}})) << "overlapping in one plane";
  EXPECT_TRUE(pair({{{1.1, 0, -1}, {1.1, 0, 1}, {2, 0, 0}}})) << "in one line with an edge";
}

TEST(TrianglePairs, AtACommonCorner) {
  const auto pair = [](const Vector3d& a, const Vector3d& b) {
    return areNeighbours({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, a, b}, {0, 1, 2}, {3, 0, 4});
  };
  EXPECT_TRUE(pair({-1, 0, 0}, {0, -1, 0}));
  EXPECT_TRUE(pair({1, 0, 1}, {0, 1, 1}));
  EXPECT_TRUE(pair({1, -0.1, 0}, {0, -1, 0})) << "in one plane";
  EXPECT_FALSE(pair({1, 1, 1}, {1, 1, -1})) << "through the other's middle";
  EXPECT_FALSE(pair({1, 1, 0}, {1, 1, -1})) << "an edge on the other's face";
  EXPECT_FALSE(pair({1, 0, 0}, {0, -1, 0})) << "along the other's edge";
}

TEST(TrianglePairs, AtACommonEdge) {
  const auto pair = [](const Vector3d& a) { return areNeighbours({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, a}, {0, 1, 2}, {1, 0, 3}); };
  EXPECT_TRUE(pair({0, -1, 0}));
  EXPECT_TRUE(pair({0, 1, 1e-6})) << "folded, but not shut";
  EXPECT_FALSE(pair({0, 1, 1e-13}));
  EXPECT_FALSE(pair({0.3, 0.5, 0})) << "folded shut";
  EXPECT_FALSE(areNeighbours({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}, {1, 0, 2})) << "the same corners";
}

TEST(TrianglePairs, AllOfConvexShapes) {
  for (const TriangleMesh& mesh : {test_shapes::sphere(0.5, 4), test_shapes::box(1, 1, 1, 3)})
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t u = 0; u < t; ++u) EXPECT_TRUE(meetOnlyAsNeighbours(mesh, static_cast<int>(t), static_cast<int>(u), 1));
}

// Random input.

/// Whether a segment crosses a triangle.
bool crosses(const Vector3d& from, const Vector3d& to, const std::array<Vector3d, 3>& t) {
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double low = normal.dot(from - t[0]), high = normal.dot(to - t[0]);
  if ((low > 0) == (high > 0)) return false;
  const Vector3d p = from + (to - from) * (low / (low - high));
  return std::min({normal.dot((t[1] - t[0]).cross(p - t[0])), normal.dot((t[2] - t[1]).cross(p - t[1])),
                   normal.dot((t[0] - t[2]).cross(p - t[2]))}) > 0;
}

TEST(TrianglePairs, AgreeWithTheCrossingsOfTheirEdges) {
  int apart = 0, crossing = 0;
  for (std::uint32_t seed = 0; seed < 4000; ++seed) {
    RandomPoints random(seed);
    const std::size_t common = seed % 2;
    std::vector<Vector3d> vertices = random.cloud(6 - common, 0.5);
    const Triangle t{0, 1, 2}, u = common ? Triangle{0, 3, 4} : Triangle{3, 4, 5};
    const auto cornersOf = [&](const Triangle& of) {
      std::array<Vector3d, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = vertices[static_cast<std::size_t>(of[k])];
      return corners;
    };
    const std::array<Vector3d, 3> a = cornersOf(t), b = cornersOf(u);
    bool cross = false;
    for (std::size_t k = common; k < (common ? 2 : 3); ++k)  // with a common corner only the sides across from it can cross
      cross = cross || crosses(a[k], a[(k + 1) % 3], b) || crosses(b[k], b[(k + 1) % 3], a);
    EXPECT_EQ(areNeighbours(vertices, t, u), !cross) << seed;
    ++(cross ? crossing : apart);
  }
  EXPECT_GT(apart, 500);
  EXPECT_GT(crossing, 300);
}

}  // namespace
}  // namespace collision_hulls
