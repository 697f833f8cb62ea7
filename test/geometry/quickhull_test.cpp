#include "geometry/quickhull.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

/// Closed, outward, one face per triangle, and every point beneath every face.
void expectHull(const std::optional<ConvexHull>& hull, const Points& points) {
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->triangles.size(), 2 * hull->vertices.size() - 4);
  ASSERT_EQ(hull->faces.size(), hull->triangles.size());
  double beyond = 0;
  for (const Vector3d& p : points) beyond = std::max(beyond, planeDistance(*hull, p));
  EXPECT_LE(beyond, 1e-14);
  for (std::size_t i = 0; i < hull->triangles.size(); ++i)
    for (int v : hull->triangles[i]) EXPECT_NEAR(hull->faces[i].distance(hull->vertices[static_cast<std::size_t>(v)]), 0, 1e-10);
}

// Degenerate input: nothing to build from, and a careful builder is asked for.

TEST(Quickhull, RefusesWhatDoesNotSpanSpace) {
  test_shapes::RandomPoints random(1);
  EXPECT_FALSE(quickhull({}));
  EXPECT_FALSE(quickhull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(quickhull(Points(10, Vector3d(1, 2, 3))));
  Points line, plane;
  for (int i = 0; i < 20; ++i) {
    line.push_back(random.number() * Vector3d(1, 2, 3));
    plane.push_back({random.number(), random.number(), 0});
  }
  EXPECT_FALSE(quickhull(line));
  EXPECT_FALSE(quickhull(plane));
}

// Closed form.

TEST(Quickhull, Tetrahedron) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto hull = quickhull(points);
  expectHull(hull, points);
  EXPECT_EQ(hull->vertices.size(), 4u);
  EXPECT_NEAR(volume(*hull), 1.0 / 6, 1e-15);
}

TEST(Quickhull, CubeWithPointsInsideAndTwice) {
  Points points = test_shapes::box(1, 1, 1).vertices;
  points.insert(points.end(), points.begin(), points.begin() + 8);
  points.push_back({0.5, 0.5, 0.5});
  const auto hull = quickhull(points);
  expectHull(hull, points);
  EXPECT_EQ(hull->vertices.size(), 8u);
  EXPECT_NEAR(volume(*hull), 1, 1e-14);
}

// Random.

TEST(Quickhull, RandomPointsOnASphereAreAllVertices) {
  test_shapes::RandomPoints random(2);
  Points points;
  for (int i = 0; i < 3000; ++i) points.push_back(random.onSphere());
  const auto hull = quickhull(points);
  expectHull(hull, points);
  EXPECT_EQ(hull->vertices.size(), points.size());
}

TEST(Quickhull, RandomCloudsOfEverySize) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    test_shapes::RandomPoints random(seed);
    const Points points = random.cloud(4 + seed);
    expectHull(quickhull(points), points);
  }
}

TEST(Quickhull, WhatItDoesNotRefuseIsRight) {
  int built = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    test_shapes::RandomPoints random(seed);
    Points points;  // of a coarse grid, so that many lie in one plane or on one line
    for (int i = 0; i < 60; ++i) points.push_back(Vector3d(random.index(5), random.index(5), random.index(5)) - Vector3d(2, 2, 2));
    const auto hull = quickhull(points);
    if (!hull) continue;
    ++built;
    expectHull(hull, points);
  }
  EXPECT_GT(built, 0);
}

}  // namespace
}  // namespace collision_hulls
