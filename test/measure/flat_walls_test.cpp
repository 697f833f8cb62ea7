#include "measure/flat_walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision_hulls/measure/solid.h"
#include "measure/protrusion.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

constexpr double kUnknown = std::numeric_limits<double>::infinity();

TriangleMesh boxAt(const Vector3d& low, const Vector3d& high) {
  const Vector3d sides = high - low;
  return test_shapes::moved(test_shapes::box(sides.x(), sides.y(), sides.z()), low);
}

/// A unit cube, and one against it, smaller all around, whose wall covers a part of the cube's in x = 1.
Solid steppedCubes(double gap = 0) {
  return solidOf(test_shapes::merged({boxAt({0, 0, 0}, {1, 1, 1}), boxAt({1 + gap, 0.2, 0.2}, {2, 0.8, 0.8})}));
}

double distanceAt(const Solid& solid, const Vector3d& p, double radius) {
  return solid.distanceAmongWalls(p, solid.distanceToSurface(p), radius);
}
double summitAt(const Solid& solid, const Vector3d& p, double radius) {
  return solid.summitAmongWalls(p, solid.distanceToSurface(p), radius);
}

TEST(FlatWalls, BetweenBoxesThatTouch) {
  const Solid solid = steppedCubes();
  EXPECT_LT(distanceAt(solid, {1, 0.5, 0.5}, 0.25), 1e-6);
  EXPECT_LT(distanceAt(solid, {0.9, 0.4, 0.5}, 0.15), 1e-6);
  EXPECT_EQ(distanceAt(solid, {1, 0.5, 0.7}, 0.25), kUnknown) << "reaches out beside the smaller cube";
  EXPECT_EQ(distanceAt(solid, {0, 0.5, 0.5}, 0.25), kUnknown);
}

TEST(FlatWalls, WhereAWallEndsAtAnother) {
  const Solid touching = solidOf(test_shapes::merged({boxAt({0, 0, 0}, {1, 1, 1}), boxAt({1, 0, 0}, {3, 2, 1})}));
  EXPECT_LT(summitAt(touching, {1, 0.5, 1.05}, 0.1), 1e-6) << "both are level with the top";
  EXPECT_EQ(distanceAt(touching, {1, 0.5, 1.05}, 0.1), kUnknown);
  EXPECT_LT(summitAt(steppedCubes(), {1.05, 0.5, 0.85}, 0.04), 1e-5) << "in a concave corner";
  EXPECT_EQ(summitAt(steppedCubes(), {1.05, 0.5, 0.85}, 0.6), kUnknown) << "with edges in reach";
}

// A tenth of the smaller cube's distance is no slab.
TEST(FlatWalls, BoxesThatDoNotTouch) {
  const Solid solid = steppedCubes(0.01);
  EXPECT_EQ(distanceAt(solid, {0.99, 0.5, 0.5}, 0.1), kUnknown);
  EXPECT_EQ(summitAt(solid, {1.002, 0.5, 0.5}, 0.05), kUnknown) << "half way, there is one";
}

// Gaps thinner than a slab: what is outside is in them.
TEST(FlatWalls, TheBoundHoldsInGapsAsThinAsRounding) {
  RandomPoints random(3);
  int known = 0;
  for (int i = 0; i < 200; ++i) {
    const double gap = random.number(0, 3e-6);
    const Solid solid = steppedCubes(gap);
    const Vector3d p(1 + random.number(-0.05, 0.05), random.number(0.4, 0.6), random.number(0.4, 0.6));
    const double any = distanceAt(solid, p, 0.1), summit = summitAt(solid, p, 0.02);
    if (any < kUnknown) ++known;
    EXPECT_GE(any, solid.distance({1 + gap / 2, p.y(), p.z()})) << gap;
    EXPECT_GE(summit, solid.distance({1 + gap / 2, p.y(), p.z()})) << gap;
  }
  EXPECT_GT(known, 20);
}

/// Two boxes side by side, level at the top, z = 0.
TriangleMesh twoBoxes() {
  return test_shapes::merged({boxAt({-2, -2, -1}, {0, 2, 0}), boxAt({0, -2, -1}, {2, 2, 0})});
}

// A summit half way to what is above, in reach only of the balls about what is nearest to its points.
TEST(FlatWalls, ASummitUnderACeilingIsNotRuledOut) {
  const Solid solid = solidOf(test_shapes::merged({twoBoxes(), boxAt({-2, -2, 1}, {2, 2, 2})}));
  EXPECT_LT(summitAt(solid, {0, 0, 0.2}, 0.19), 1e-5) << "so that the test can tell";
  EXPECT_EQ(summitAt(solid, {0, 0, 0.2}, 0.31), kUnknown);
}

// Under thin boxes, there is more of the outside.
TEST(FlatWalls, WhatIsBehindThinBoxesIsNotOverlooked) {
  const Solid solid = solidOf(test_shapes::merged({boxAt({-2, -2, -0.1}, {0, 2, 0}), boxAt({0, -2, -0.1}, {2, 2, 0})}));
  EXPECT_LT(summitAt(solid, {0, 0, 0.02}, 0.02), 1e-5) << "so that the test can tell";
  EXPECT_EQ(summitAt(solid, {0, 0, 0.05}, 0.1), kUnknown);
}

// Sheets enclose nothing, and are surface all the same.
TEST(FlatWalls, SheetsThatStandInFrontMakeSummits) {
  const auto sheetAt = [](double x) {
    TriangleMesh sheet = test_shapes::sheet(1, 1);
    for (Vector3d& v : sheet.vertices) v = Vector3d(x, v.x() - 0.5, v.y() + 0.001);
    return sheet;
  };
  const Solid solid = solidOf(test_shapes::merged({twoBoxes(), sheetAt(-0.1), sheetAt(0.1)}));
  EXPECT_EQ(summitAt(solid, {0, 0, 0.12}, 0.05), kUnknown);
  EXPECT_LT(summitAt(solid, {0, 1.5, 0.12}, 0.05), 1e-5) << "beside them";
}

// Before walls that face each other, no direction leads away from both.
TEST(FlatWalls, ASummitInAGrooveIsNotRuledOut) {
  const Solid solid =
      solidOf(test_shapes::merged({boxAt({-2, -2, -1}, {0, 2, 1}), boxAt({0.1, -2, -1}, {2, 2, 1}), boxAt({2, -2, -1}, {3, 2, 1})}));
  EXPECT_EQ(summitAt(solid, {0.05, 0, 0}, 0.02), kUnknown);
}

// A box without thickness: its walls lie face to face, and nothing is inside.
TEST(FlatWalls, NothingIsInsideABoxWithoutThickness) {
  const Solid solid = solidOf(test_shapes::merged({boxAt({0, 0, 0}, {1, 1, 1e-7}), boxAt({0, 0, 2}, {1, 1, 3})}));
  EXPECT_EQ(distanceAt(solid, {0.5, 0.5, 0}, 0.1), kUnknown);
  EXPECT_EQ(summitAt(solid, {0.5, 0.5, 0.1}, 0.05), kUnknown);
}

// What the octree makes of it: without this, the bound was 3 mm, at the edges where the walls end.
TEST(FlatWalls, AHullOfBoxesThatTouchProtrudesByRoundingAlone) {
  std::vector<TriangleMesh> boxes;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) boxes.push_back(boxAt({0.4 * i, 0.3 * k, 0}, {0.4 * i + 0.4, 0.3 * k + 0.3, 0.5}));
  const TriangleMesh mesh = test_shapes::merged(boxes);
  const double e = 1e-6;  // larger by that all around
  const Protrusion p = protrusion({test_shapes::boxHull({-e, -e, -e}, {1.2 + e, 0.9 + e, 0.5 + e})}, solidOf(mesh), 1e-5);
  EXPECT_GE(p.bound, std::sqrt(3) * e);
  EXPECT_LE(p.bound, 1.5e-5);
}

}  // namespace
}  // namespace collision_hulls
