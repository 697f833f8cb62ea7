#include "measure/cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_hulls/measure/measures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;
using test_shapes::RandomPoints;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distanceToUnion(const std::vector<ConvexHull>& hulls, const Vector3d& p) {
  double least = kInfinity;
  for (const ConvexHull& hull : hulls) least = std::min(least, distance(hull, p));
  return least;
}

// Degenerate input.

TEST(Uncovered, WithoutHullsNothingIsCovered) {
  EXPECT_EQ(uncovered(test_shapes::box(1, 1, 1), {}), kInfinity);
  EXPECT_EQ(uncovered({}, {}), 0);
  EXPECT_EQ(uncovered({}, {boxHull({0, 0, 0}, {1, 1, 1})}), 0);
}

TEST(Uncovered, RefusesMeshesThatAreNotSound) {
  const std::vector<ConvexHull> hulls{boxHull({0, 0, 0}, {1, 1, 1})};
  const Vector3d nowhere = Vector3d::Constant(std::nan("")), here(0.5, 0.5, 0.5);
  const auto code = [&](const TriangleMesh& mesh) {
    try {
      uncovered(mesh, hulls);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  EXPECT_EQ(code({{nowhere, nowhere, nowhere}, {{0, 1, 2}}}), ErrorCode::kNonFiniteCoordinate);
  EXPECT_EQ(code({{here, here, nowhere}, {{0, 1, 2}}}), ErrorCode::kNonFiniteCoordinate);
  EXPECT_EQ(code({{here, here, here}, {{0, 1, 3}}}), ErrorCode::kIndexOutOfRange);
}

TEST(Uncovered, RefusesHullsThatAreNotSound) {
  ConvexHull hull = boxHull({0, 0, 0}, {1, 1, 1});
  hull.vertices[0].x() = std::nan("");
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  EXPECT_THROW(uncovered(box, {hull}), Error);
  EXPECT_THROW(unionVolume({hull}), Error);
  EXPECT_THROW(coveredShare({hull}, Solid(repair(box))), Error);
}

TEST(Uncovered, TrianglesWithoutArea) {
  const std::vector<ConvexHull> hulls{boxHull({0, 0, 0}, {1, 1, 1})};
  const std::vector<Vector3d> points{{0.5, 0.5, 0.5}, {0.7, 0.5, 0.5}, {0.5, 0.5, 3}};
  EXPECT_EQ(uncovered({points, {{0, 0, 0}}}, hulls), 0);
  EXPECT_EQ(uncovered({points, {{0, 1, 0}}}, hulls), 0);
  EXPECT_NEAR(uncovered({points, {{2, 2, 2}}}, hulls), 2, 1e-12);
  EXPECT_NEAR(uncovered({points, {{0, 2, 0}}}, hulls), 2, 1e-12);
}

TEST(Uncovered, ASegmentAcrossAGap) {
  const std::vector<ConvexHull> hulls{boxHull({0, 0, 0}, {1, 1, 1}), boxHull({2, 0, 0}, {3, 1, 1})};
  EXPECT_NEAR(uncovered({{{0.5, 0.5, 0.5}, {2.5, 0.5, 0.5}}, {{0, 1, 1}}}, hulls), 0.5, 1e-9);
}

// Closed-form answers.

TEST(Uncovered, AMeshIsCoveredByItsHull) {
  for (const TriangleMesh& mesh : {test_shapes::torus(), test_shapes::sheet(), test_shapes::flask()}) {
    EXPECT_EQ(uncovered(mesh, {test_shapes::hullOf(mesh)}), 0);
    const TriangleMesh far = test_shapes::moved(mesh, {1e5, -1e5, 1e5});
    EXPECT_EQ(uncovered(far, {test_shapes::hullOf(far)}), 0);
  }
}

TEST(Uncovered, APartOutsideOneHull) {
  const TriangleMesh mesh = test_shapes::box(1, 1, 1, 3);
  EXPECT_NEAR(uncovered(mesh, {boxHull({0, 0, 0}, {0.75, 1, 1})}), 0.25, 1e-12);
  EXPECT_NEAR(uncovered(mesh, {boxHull({0, 0, 0}, {0.5, 0.5, 0.5})}), std::sqrt(0.75), 1e-12);
}

// The hull's box holds the corner that the hull lacks.
TEST(Uncovered, ACornerBeyondASlantedFace) {
  const TriangleMesh mesh = test_shapes::box(1, 1, 1);
  for (const double cut : {0.5, 0.1, 0.02, 1e-3, 1e-6}) {
    std::vector<Vector3d> points{{1, 1, 1 - cut}, {1, 1 - cut, 1}, {1 - cut, 1, 1}};
    for (const Vector3d& v : mesh.vertices)
      if (v.sum() < 2.5) points.push_back(v);
    const std::vector<ConvexHull> hulls{convexHull(points)};
    EXPECT_NEAR(uncovered(mesh, hulls), cut / std::sqrt(3.0), 0.02 * cut) << cut;
    EXPECT_GT(uncoveredTriangles(mesh, hulls).size(), 2U) << cut;
  }
}

TEST(Uncovered, ATriangleThatOnlyTheUnionCovers) {
  const TriangleMesh mesh{{{0.1, 0.1, 0.5}, {1.9, 0.1, 0.5}, {1, 0.9, 0.5}}, {{0, 1, 2}}};
  EXPECT_EQ(uncovered(mesh, {boxHull({0, 0, 0}, {1, 1, 1}), boxHull({1, 0, 0}, {2, 1, 1})}), 0);
  EXPECT_EQ(uncovered(mesh, {boxHull({0, 0, 0}, {1.2, 1, 1}), boxHull({0.8, 0, 0}, {2, 1, 1})}), 0);
  // In a face shared by both hulls, and divided in four.
  EXPECT_EQ(uncovered(test_shapes::moved(mesh, {0, 0, 0.5}), {boxHull({0, 0, 0}, {1, 1, 1}), boxHull({1, 0, 0}, {2, 1, 1})}), 0);
  EXPECT_EQ(uncovered(mesh, {boxHull({0, 0, 0}, {1, 0.3, 1}), boxHull({1, 0, 0}, {2, 0.3, 1}), boxHull({0, 0.3, 0}, {1, 1, 1}),
                             boxHull({1, 0.3, 0}, {2, 1, 1})}),
            0);
}

TEST(Uncovered, ASlitBetweenTwoHulls) {
  const TriangleMesh mesh{{{0.1, 0.1, 0.5}, {1.9, 0.1, 0.5}, {1, 0.9, 0.5}}, {{0, 1, 2}}};
  for (double width : {0.5, 0.1, 1e-3, 1e-6, 1e-9, 1e-11}) {
    const std::vector<ConvexHull> hulls{boxHull({0, 0, 0}, {1 - width / 2, 1, 1}), boxHull({1 + width / 2, 0, 0}, {2, 1, 1})};
    EXPECT_NEAR(uncovered(mesh, hulls), width / 2, 0.005 * width + 5e-12) << width;
    EXPECT_GT(uncovered(mesh, hulls), 0) << width;
    ASSERT_EQ(uncoveredTriangles(mesh, hulls).size(), 1u);
  }
}

TEST(Uncovered, AHoleBetweenFourHulls) {
  // Boxes around a square hole of 0.2 and a triangle over all of them: the hole's middle is 0.1 away.
  const TriangleMesh mesh{{{-3, -3, 0.5}, {3, -3, 0.5}, {0, 4, 0.5}}, {{0, 1, 2}}};
  const std::vector<ConvexHull> hulls{boxHull({-9, -9, 0}, {9, -0.1, 1}), boxHull({-9, 0.1, 0}, {9, 9, 1}),
                                      boxHull({-9, -1, 0}, {-0.1, 1, 1}), boxHull({0.1, -1, 0}, {9, 1, 1})};
  EXPECT_NEAR(uncovered(mesh, hulls), 0.1, 1e-3);
}

TEST(Uncovered, ManyHullsThatHardlyMissEachOther) {
  constexpr int kCells = 6;
  constexpr double kSlit = 2e-3, kSide = 1.0 / kCells;
  std::vector<ConvexHull> hulls;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const Vector3d low(i * kSide + kSlit / 2, j * kSide + kSlit / 2, -0.1);
      hulls.push_back(boxHull(low, low + Vector3d(kSide - kSlit, kSide - kSlit, 0.2)));
    }
  const TriangleMesh mesh = test_shapes::moved(test_shapes::sheet(1 - 2 * kSlit, 1 - 2 * kSlit), {kSlit, kSlit, 0});
  const double where_slits_cross = kSlit / std::sqrt(2);
  EXPECT_NEAR(uncovered(mesh, hulls), where_slits_cross, 0.01 * where_slits_cross);
}

TEST(Uncovered, NamesTheTrianglesInOrder) {
  const TriangleMesh mesh = test_shapes::box(1, 1, 1, 4);
  const std::vector<int> missing = uncoveredTriangles(mesh, {boxHull({0, 0, 0}, {1, 1, 0.6})});
  ASSERT_FALSE(missing.empty());
  std::size_t expected = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    expected += std::max({mesh.corner(t, 0).z(), mesh.corner(t, 1).z(), mesh.corner(t, 2).z()}) > 0.6;
  EXPECT_EQ(missing.size(), expected);
  for (std::size_t i = 1; i < missing.size(); ++i) EXPECT_LT(missing[i - 1], missing[i]);
}

TEST(Uncovered, ASlitFarFromTheOriginIsStillFound) {
  const Vector3d far(1e5, 1e5, 1e5);
  const TriangleMesh mesh = test_shapes::moved({{{0.1, 0.1, 0.5}, {1.9, 0.1, 0.5}, {1, 0.9, 0.5}}, {{0, 1, 2}}}, far);
  EXPECT_EQ(uncovered(mesh, {boxHull(far, far + Vector3d(1, 1, 1)), boxHull(far + Vector3d(1, 0, 0), far + Vector3d(2, 1, 1))}), 0);
  EXPECT_NEAR(uncovered(mesh, {boxHull(far, far + Vector3d(1, 1, 1)), boxHull(far + Vector3d(1.001, 0, 0), far + Vector3d(2, 1, 1))}),
              0.0005, 1e-6);
}

// What counts as rounding is 1e-12 of the coordinates' size, no more.
TEST(Uncovered, AGapJustAboveRoundingIsFound) {
  const TriangleMesh mesh = test_shapes::box(1, 1, 1);
  for (const double gap : {1e-6, 1e-9, 1e-11}) {
    EXPECT_NEAR(uncovered(mesh, {boxHull({0, 0, 0}, {1, 1, 1 - gap})}), gap, 0.02 * gap + 1e-12);
    EXPECT_NEAR(uncovered(mesh, {boxHull({0, 0, 0}, {0.5, 1, 1}), boxHull({0.5 + gap, 0, 0}, {1, 1, 1})}), gap / 2, 0.02 * gap + 1e-12);
  }
  EXPECT_EQ(uncovered(mesh, {boxHull({0, 0, 0}, {1, 1, 1 - 1e-13})}), 0);
}

// Random input.

TEST(Uncovered, AgreesWithSamplesOfTheSurface) {
  int covered = 0, open = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const TriangleMesh mesh = random.soup(2, 0.5);
    std::vector<ConvexHull> hulls;
    for (std::uint32_t h = 0; h < 2 + seed % 12; ++h) {
      std::vector<Vector3d> points = random.cloud(8, 0.5 + 0.3 * (seed % 8));
      const Vector3d middle = random.inCube(0.8);
      for (Vector3d& p : points) p += middle;
      hulls.push_back(convexHull(points));
    }
    const double most = uncovered(mesh, hulls);
    double sampled = 0;
    for (int i = 0; i < 4000; ++i) sampled = std::max(sampled, distanceToUnion(hulls, random.on(mesh)));
    EXPECT_LE(sampled, most + 1e-12);
    EXPECT_LE(most, sampled * 1.1 + 0.03) << "none of the samples is nearly as far";
    ++(most == 0 ? covered : open);
  }
  EXPECT_GT(covered, 5);
  EXPECT_GT(open, 5);
}

TEST(Uncovered, MoreHullsNeverUncover) {
  RandomPoints random(1);
  const TriangleMesh mesh = random.soup(5, 1);
  std::vector<ConvexHull> hulls;
  double last = kInfinity;
  for (int h = 0; h < 25; ++h) {
    std::vector<Vector3d> points = random.cloud(8, 0.7);
    const Vector3d middle = random.inCube(1.5);
    for (Vector3d& p : points) p += middle;
    hulls.push_back(convexHull(points));
    const double most = uncovered(mesh, hulls);
    EXPECT_LE(most, last * 1.01);
    last = most;
  }
}

TEST(UncoveredPolygons, AreWhatTheHullsLeave) {
  const std::vector<ConvexHull> hulls = {boxHull({-1, -1, -1}, {0.25, 2, 1}), boxHull({0.5, -1, -1}, {2, 2, 1})};
  double area = 0;
  for (const std::vector<Vector3d>& polygon : uncoveredPolygons(test_shapes::sheet(1, 1, 3), hulls)) {
    for (std::size_t i = 2; i < polygon.size(); ++i) area += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]).norm() / 2;
    for (const Vector3d& p : polygon) EXPECT_TRUE(p.x() > 0.25 - 1e-9 && p.x() < 0.5 + 1e-9) << p.transpose();
  }
  EXPECT_NEAR(area, 0.25, 1e-9);
  EXPECT_TRUE(uncoveredPolygons(test_shapes::sheet(), {boxHull({-1, -1, -1}, {2, 2, 1})}).empty());
}

TEST(UnionVolume, OverlappingHulls) {
  EXPECT_EQ(unionVolume({}), 0);
  EXPECT_NEAR(unionVolume({boxHull({0, 0, 0}, {1, 2, 3})}), 6, 0.06);
  EXPECT_NEAR(unionVolume({boxHull({0, 0, 0}, {1, 1, 1}), boxHull({0.5, 0, 0}, {1.5, 1, 1})}), 1.5, 0.015);
  EXPECT_NEAR(unionVolume({boxHull({0, 0, 0}, {1, 1, 1}), boxHull({1, 1, 1}, {2, 2, 2})}), 2, 1e-9);
}

TEST(UnionVolume, ThinHullsFarApart) {
  const ConvexHull rod = boxHull({0, 0, 0}, {1, 1e-3, 1e-3}), other = boxHull({0, 5, 5}, {1, 5 + 1e-3, 5 + 1e-3});
  EXPECT_NEAR(unionVolume({rod, other}), 2e-6, 1e-12);
  EXPECT_NEAR(unionVolume({rod, rod, other, other}), 2e-6, 1e-12);
}

TEST(CoveredShare, ABlock) {
  const Solid block(repair(test_shapes::box(2, 1, 1)));
  const auto share = [&](double from, double to) {
    return coveredShare({boxHull({from, -3, -3}, {to, 3, 3}), boxHull({-0.001, -0.001, -0.001}, {2.001, 0.001, 1.001})}, block);
  };
  EXPECT_NEAR(share(-1, 3), 1, 0);
  EXPECT_NEAR(share(-1, 0.5), 0.25, 0.03);
}

TEST(CoveredShare, WithoutAnInside) {
  EXPECT_EQ(coveredShare({boxHull({0, 0, 0}, {1, 1, 1})}, Solid(repair(test_shapes::sheet()))), 1);
  EXPECT_EQ(coveredShare({}, Solid(repair(test_shapes::box(1, 1, 1)))), 1);
}

}  // namespace
}  // namespace collision_hulls
