#include "geometry/quickhull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

/// Closed, outward, one face per triangle, and every point below every face.
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

// Degenerate input: nothing to build from, so a more careful builder is needed.

TEST(Quickhull, RefusesSetsThatDoNotSpanSpace) {
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

// Closed-form answers.

TEST(Quickhull, Tetrahedron) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto hull = quickhull(points);
  expectHull(hull, points);
  EXPECT_EQ(hull->vertices.size(), 4u);
  EXPECT_NEAR(volume(*hull), 1.0 / 6, 1e-15);
}

TEST(Quickhull, CubeWithInnerAndDuplicatePoints) {
  Points points = test_shapes::box(1, 1, 1).vertices;
  points.insert(points.end(), points.begin(), points.begin() + 8);
  points.push_back({0.5, 0.5, 0.5});
  const auto hull = quickhull(points);
  expectHull(hull, points);
  EXPECT_EQ(hull->vertices.size(), 8u);
  EXPECT_NEAR(volume(*hull), 1, 1e-14);
}

// Random input.

TEST(Quickhull, RandomPointsOnASphereAreAllVertices) {
  test_shapes::RandomPoints random(2);
  Points points;
  for (int i = 0; i < 3000; ++i) points.push_back(random.onSphere());
  const auto hull = quickhull(points);
  expectHull(hull, points);
  EXPECT_EQ(hull->vertices.size(), points.size());
}

// So many faces that replaced ones are forgotten.
TEST(Quickhull, AVeryLargeHull) {
  constexpr std::size_t kCorners = 60'000;
  test_shapes::RandomPoints random(3);
  Points points;
  while (points.size() < kCorners) points.push_back(random.onSphere());
  while (points.size() < kCorners + 5000) points.push_back(0.9 * random.onSphere());
  const auto hull = quickhull(points);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->vertices.size(), kCorners);
  EXPECT_EQ(hull->triangles.size(), 2 * kCorners - 4);
  for (std::size_t i = 0; i < hull->faces.size(); i += 500) {
    const HalfSpace& face = hull->faces[i];
    EXPECT_TRUE(std::all_of(points.begin(), points.end(), [&](const Vector3d& p) { return face.distance(p) <= 1e-14; })) << i;
    for (int v : hull->triangles[i]) EXPECT_NEAR(face.distance(hull->vertices[static_cast<std::size_t>(v)]), 0, 1e-10);
  }
}

TEST(Quickhull, RandomCloudsOfAnySize) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    test_shapes::RandomPoints random(seed);
    const Points points = random.cloud(4 + seed);
    expectHull(quickhull(points), points);
  }
}

// So many points that extreme ones are added first.
TEST(Quickhull, ManyPointsInsideOnFacesAndInClusters) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    test_shapes::RandomPoints random(seed);
    Points ball, cube, heaps;
    for (int i = 0; i < 3000; ++i) {
      ball.push_back(random.onSphere() * std::cbrt(std::abs(random.number())));
      Vector3d p(random.number(), random.number(), random.number());
      p[i % 3] = i % 2 == 0 ? 1 : -1;
      cube.push_back(p);
      heaps.push_back(random.onSphere() * 1e-3 + Vector3d(random.index(3), random.index(3), random.index(3)) - Vector3d(1, 1, 1));
    }
    expectHull(quickhull(ball), ball);
    if (const auto hull = quickhull(cube)) expectHull(hull, cube);
    if (const auto hull = quickhull(heaps)) expectHull(hull, heaps);
  }
}

TEST(Quickhull, CanBeCancelled) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(quickhull(test_shapes::sphere(1, 20).vertices, control), Error);
}

TEST(Quickhull, IsCorrectWheneverItDoesNotRefuse) {
  int built = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    test_shapes::RandomPoints random(seed);
    Points points;  // on a coarse grid, so many are coplanar or collinear
    for (int i = 0; i < 60; ++i) points.push_back(Vector3d(random.index(5), random.index(5), random.index(5)) - Vector3d(2, 2, 2));
    const auto hull = quickhull(points);
    if (!hull) continue;
    ++built;
    expectHull(hull, points);
  }
  EXPECT_GT(built, 0);
}

// A vertex that lost several of its faces at once was once put into a list of points twice, and the walk along that list never ended.
TEST(Quickhull, AVertexOfSeveralLevelFacesIsReassignedOnce) {
  const Points points{{-0.0048563383042567812, 0.0087360428114834215, -0.0049686220901937793},
                      {-0.0048563389424097145, 0.0087360427779745384, -0.004968622028528831},
                      {-0.0048563383042567812, -0.0089844043292082523, 0.019222903308025036},
                      {-0.0048563389424097145, 0.0085844050155936824, -0.0046895696436424425},
                      {-0.0048563389424097145, 0.0089408288872272201, -0.0055829814290995206},
                      {-0.0048563383042567812, 0.0089408288775979228, -0.0055829813613496974},
                      {0.0043558238390695656, 0.0069844040082751857, -0.01922290335683121},
                      {0.0043558238390695656, 0.0085844050155936824, -0.0046895696436424425},
                      {-0.0020353086750268604, 0.0085844050155936824, -0.0046895696436424425},
                      {0.0048558323029291237, 0.0084844070481120692, -0.017222903029005664},
                      {0.0043558238390695656, 0.008984404336100732, -0.0058895697006393841},
                      {-0.0018268914576757347, 0.0088951165782271968, -0.0052613586307872703},
                      {-0.0020353086750268604, 0.0077638942089621327, -0.019099090841397274},
                      {0.0048558323029291237, 0.0081844056950866328, -0.004989569599684017},
                      {-0.0020353086750268604, -1.5597139114226222e-05, -0.01922290335683121}};
  if (const auto hull = quickhull(points)) expectHull(hull, points);
}

// A face was once folded back onto others in its plane: no edge was dented, yet a third of the hull's size lay beyond a face.
TEST(Quickhull, DetectsAFoldedFace) {
  const Points points{{0.0025420871112633303, -0.023752397285218111, 0.0043372799437768686},
                      {0.0028640417163243448, -0.022760599977479062, 0.016632416128108285},
                      {0.0022063369336474403, -0.02478666842003039, -0.0084840905565322002},
                      {0.02058939991130912, 0.0037524788719836485, -0.011234209416838387},
                      {0.021911260040000907, 0.0056899517803461266, -0.014309084072297544},
                      {-0.0015265190401557716, -0.028520089478221326, 0.020679943748328336},
                      {0.0031085622695493642, -0.0080234186306983937, 0.025970783248816444}};
  if (const auto hull = quickhull(points)) expectHull(hull, points);
}

}  // namespace
}  // namespace collision_hulls
