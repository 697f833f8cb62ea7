#include "geometry/hull_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "counted_looks.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

double furthest(const ConvexHull& hull, const Vector3d& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector3d& v : hull.vertices) most = std::max(most, direction.dot(v));
  return most;
}

/// From every start and in many directions: as far as a search over all vertices.
void expectSupport(const ConvexHull& hull, std::uint32_t seed) {
  const HullSupport support(hull);
  test_shapes::RandomPoints random(seed);
  for (int start = 0; start < static_cast<int>(hull.vertices.size()); ++start) {
    const Vector3d direction = random.onSphere();
    const int v = support.furthest(direction, start);
    EXPECT_NEAR(direction.dot(hull.vertices[static_cast<std::size_t>(v)]), furthest(hull, direction), 1e-9);
  }
}

TEST(HullSupport, Box) {
  const ConvexHull box = convexHull(test_shapes::box(1, 2, 3).vertices);
  const HullSupport support(box);
  for (int start = 0; start < 8; ++start)
    EXPECT_EQ(box.vertices[static_cast<std::size_t>(support.furthest({1, 1, 1}, start))], Vector3d(1, 2, 3));
}

TEST(HullSupport, RoundAndFlatHulls) {
  expectSupport(convexHull(test_shapes::sphere(1, 12).vertices), 1);
  expectSupport(convexHull(test_shapes::flange().vertices), 2);
  expectSupport(convexHull(test_shapes::sheet(1, 2, 5).vertices), 3);
}

TEST(HullSupport, RandomHulls) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    test_shapes::RandomPoints random(seed);
    expectSupport(convexHull(random.cloud(4 + 5 * seed)), seed);
  }
}

TEST(LeastWidth, OfABox) {
  EXPECT_NEAR(leastWidth(convexHull(test_shapes::box(1, 2, 3).vertices)), 1, 1e-10);
}

// A wedge of 2 theta whose two long faces are moved out by s: they meet s / sin(theta) beyond its edge.
TEST(Overhang, ReachesFarAtASharpEdge) {
  const double theta = 0.02, s = 1e-5, y = std::sin(theta), x = std::cos(theta);
  ConvexHull wedge = convexHull({{0, 0, 0}, {0, 0, 1}, {x, y, 0}, {x, y, 1}, {x, -y, 0}, {x, -y, 1}});
  EXPECT_LT(overhang(wedge), 1e-9);
  for (HalfSpace& face : wedge.faces)
    if (std::abs(face.normal.y()) > 0.9) face.offset += s;
  const double beyond = s / std::sin(theta);
  EXPECT_LE(planeDistance(wedge, {-beyond * (1 - 1e-9), 0, 0.5}), 0);
  EXPECT_GE(overhang(wedge), beyond);
  EXPECT_LE(overhang(wedge), 10 * beyond);
}

// The sharper the edge at the vertex, the further the triangles stay behind it.
TEST(Overhang, AVertexThatNoFaceHolds) {
  ConvexHull box = convexHull(test_shapes::box(1, 1, 1).vertices);
  for (HalfSpace& face : box.faces) face.offset -= 1e-6 * (face.normal.x() > 0.5);
  EXPECT_GE(overhang(box), 1e-6);
  EXPECT_LE(overhang(box), 1e-5);
}

TEST(Overhang, AHullWithoutAnInsideReachesNoFurtherThanItIsWide) {
  ConvexHull flat = convexHull(test_shapes::box(1, 1, 1).vertices);
  for (Vector3d& v : flat.vertices) v.z() = 0;
  const double reach = overhang(flat);
  EXPECT_GE(reach, std::sqrt(2) - 1e-9);
  EXPECT_LE(reach, 2);
}

TEST(Overhang, OfTheThinnestPlate) {
  const ConvexHull plate = convexHull(test_shapes::sheet(1, 1, 5).vertices);
  ASSERT_GT(plate.thickness, 0);
  EXPECT_LT(overhang(plate), 2e-6);
}

TEST(Overhang, IsCancelledAmidTheComparisonOfAllWithAll) {
  const ConvexHull ball = convexHull(test_shapes::sphere(1, 16).vertices);
  const std::size_t pairs = ball.faces.size() * ball.vertices.size();
  EXPECT_GE(looksOf([&](const RunControl& control) { leastWidth(ball, control); }), looksFor(pairs));
  EXPECT_GE(looksOf([&](const RunControl& control) { overhang(ball, control); }), ball.vertices.size() + looksFor(pairs));
}

TEST(Overhang, OfHullsIsRounding) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    test_shapes::RandomPoints random(seed);
    EXPECT_LT(overhang(convexHull(random.cloud(4 + 5 * seed))), 1e-9) << seed;
  }
}

/// A needle whose faces meet at its tip, while its triangles end a little before: what they lack is nearly all of the bound.
TEST(Overhang, OfANeedleIsTheTipThatItsTrianglesLack) {
  constexpr int kSides = 16;
  constexpr double kTip = 20, kCut = 0.1;
  const auto at = [&](int i, double z) {
    const double angle = 2 * test_shapes::kPi * (i % kSides) / kSides, r = (kTip - z) / kTip;
    return Vector3d(r * std::cos(angle), r * std::sin(angle), z);
  };
  std::vector<Vector3d> whole{{0, 0, kTip}};
  test_shapes::MeshBuilder stump;
  for (int i = 0; i < kSides; ++i) {
    whole.push_back(at(i, 0));
    stump.quad(at(i, 0), at(i + 1, 0), at(i + 1, kTip - kCut), at(i, kTip - kCut));
    stump.triangle(at(i + 1, 0), at(i, 0), {0, 0, 0});
    stump.triangle(at(i, kTip - kCut), at(i + 1, kTip - kCut), {0, 0, kTip - kCut});
  }
  ConvexHull needle = convexHull(whole);
  needle.vertices = stump.mesh().vertices;
  needle.triangles = stump.mesh().triangles;
  EXPECT_GE(overhang(needle), kCut);
  EXPECT_LE(overhang(needle), 1.08 * kCut);
}

// A wedge, thinner the further from x = 0, and slowly thicker along y. Straight away from the corner at the origin, its bottom gets nearer.
TEST(WayInto, StraightAwayFromFacesUnlessThatLeadsTooNearToOthers) {
  const ConvexHull wedge =
      convexHull({{0, 0, 0}, {0, 0, -2.3}, {4.6, 0, 0}, {6, 35, 0}, {0, 300, 0}, {0, 300, -8.3}, {6, 300, 0}, {6, 300, -5.3}});
  EXPECT_NEAR(wayInto(wedge, {0, 300, 0}, 1), std::sqrt(3), 1e-9);
  EXPECT_NEAR(wayInto(wedge, {0, 0, 0}, 0.5), std::sqrt(3) / 2, 1e-9);
  EXPECT_EQ(wayInto(wedge, {0, 0, 0}, 1), std::numeric_limits<double>::infinity());
  EXPECT_EQ(wayInto(wedge, {0, 0, 0}, 3), std::numeric_limits<double>::infinity()) << "between top and bottom";
}

}  // namespace
}  // namespace collision_hulls
