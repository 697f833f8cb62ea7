#include "collision_hulls/decompose/acd.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_hulls/measure/measures.h"
#include "decompose/acd/notches.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::lBracket;

std::vector<ConvexHull> run(const TriangleMesh& mesh, double share = 0.03) {
  return acdHulls(repair(mesh), share * diagonal(mesh));
}

double totalVolume(const std::vector<ConvexHull>& hulls) {
  double sum = 0;
  for (const ConvexHull& hull : hulls) sum += volume(hull);
  return sum;
}

TEST(Acd, OnlyLoosePointsAreCovered) {
  RepairedMesh mesh;
  mesh.loose = test_shapes::loosePoints({{0, 0, 0}, {1, 0, 0}});
  const std::vector<ConvexHull> hulls = acdHulls(mesh, 0.1);
  ASSERT_EQ(hulls.size(), 1u);
  for (const Segment& point : mesh.loose) EXPECT_LE(planeDistance(hulls[0], point[0]), 1e-12);
}

TEST(Acd, RefusesWhatItCannotUse) {
  const RepairedMesh mesh = repair(lBracket());
  const auto code = [](const RepairedMesh& m, double epsilon) {
    try {
      acdHulls(m, epsilon);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  for (const double epsilon : {0.0, -1.0, std::nan(""), 0.99e-6 * diagonal(mesh.mesh)})
    EXPECT_EQ(code(mesh, epsilon), ErrorCode::kBadOption);
  EXPECT_EQ(code({}, 0.1), ErrorCode::kEmptyMesh);
}

TEST(Acd, ConvexShapesStayWhole) {
  EXPECT_EQ(run(test_shapes::box(1, 2, 3, 4), 1e-6).size(), 1u);
  EXPECT_EQ(run(test_shapes::sphere(), 1e-6).size(), 1u);
  EXPECT_EQ(run(test_shapes::sheet(1, 2, 3), 1e-6).size(), 1u);
  EXPECT_EQ(run(test_shapes::fourSpheres(), 1e-6).size(), 4u);
}

TEST(Acd, LBracketIsHalvedAtItsNotch) {
  for (int n : {1, 4}) {
    const std::vector<ConvexHull> hulls = run(lBracket(1, 0.1, 2, n), 1e-6);
    ASSERT_EQ(hulls.size(), 2u);  // by the bisecting plane x = y
    for (const ConvexHull& hull : hulls) EXPECT_NEAR(volume(hull), (2 * 0.1 - 0.01) * 2 / 2, 1e-9);
  }
}

TEST(Acd, DeepUChannelIsExact) {
  // A plane at 45 degrees through one notch, then one through the other; the first cuts off the tip of the opposite wall.
  const TriangleMesh mesh = test_shapes::uChannel(1, 1, 0.1, 2);
  const std::vector<ConvexHull> hulls = run(mesh, 1e-6);
  EXPECT_EQ(hulls.size(), 4u);
  EXPECT_NEAR(totalVolume(hulls), 0.28 * 2, 1e-9);
}

TEST(Acd, TheSkinsOfAWallStayTogether) {
  // The walls are as thick as the floor, so the planes through the notches also meet the outer edges.
  const TriangleMesh mesh = test_shapes::openBox();
  const std::vector<ConvexHull> hulls = run(mesh, 1e-6);
  EXPECT_LT(protrusion(hulls, Solid(repair(mesh)), 1e-3).bound, 2e-3);
  EXPECT_EQ(uncovered(mesh, hulls), 0);
}

TEST(Acd, EpsilonAboveTheConcavityLeavesOneHull) {
  const RepairedMesh mesh = repair(lBracket());
  const double concavity = deepestNotch(mesh.mesh, convexHull(mesh.mesh.vertices), false, {}).concavity;
  EXPECT_EQ(acdHulls(mesh, 1.001 * concavity).size(), 1u);
  EXPECT_EQ(acdHulls(mesh, 0.999 * concavity).size(), 2u);
}

TEST(Acd, AHandleIsCutThrough) {
  const TriangleMesh torus = test_shapes::torus();
  const std::vector<ConvexHull> hulls = run(torus);
  EXPECT_GT(hulls.size(), 3u);
  EXPECT_LT(totalVolume(hulls), 1.2 * 2 * test_shapes::kPi * test_shapes::kPi * 0.3 * 0.3);
  EXPECT_EQ(uncovered(torus, hulls), 0);
}

TEST(Acd, RandomTrianglesAreCovered) {
  test_shapes::RandomPoints random(7);
  for (int round = 0; round < 5; ++round) {
    SCOPED_TRACE(round);
    TriangleMesh mesh = random.soup(60);
    const TriangleMesh torus = test_shapes::torus(1, 0.3, 12, 8);
    mesh = test_shapes::merged({mesh, torus, torus, test_shapes::sheet()});
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    mesh.triangles.push_back({0, 0, 1});
    EXPECT_LE(uncovered(mesh, acdHulls(repair(mesh), 0.01)), 1e-5 * diagonal(mesh));  // the distance that welding moves vertices
  }
}

TEST(Acd, EndsEvenIfNothingIsEverConvexEnough) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 48, 24);
  const std::vector<ConvexHull> hulls = run(mesh, 1.01e-6);  // the least that is taken
  EXPECT_LE(hulls.size(), 2002u);                            // the last cut may add a few more
  EXPECT_EQ(uncovered(mesh, hulls), 0);
}

// Hulls of more than 100,000 points are rough until they are known to stay.
TEST(Acd, HullsOfManyPointsAreExact) {
  const RepairedMesh mesh = repair(test_shapes::sphere(1, 101));
  ASSERT_GT(mesh.mesh.vertices.size(), 100'000u);
  const std::vector<ConvexHull> hulls = acdHulls(mesh, 0.1);
  ASSERT_EQ(hulls.size(), 1u);
  for (std::size_t f = 0; f < hulls[0].faces.size(); f += hulls[0].faces.size() / 50) {
    double furthest = -1;
    for (const Eigen::Vector3d& v : mesh.mesh.vertices) furthest = std::max(furthest, hulls[0].faces[f].distance(v));
    EXPECT_NEAR(furthest, 0, 1e-9);
  }
}

}  // namespace
}  // namespace collision_hulls
