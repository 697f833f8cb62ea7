#include "measure/outside_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;
using test_shapes::hullOf;
using test_shapes::inHull;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

OutsideDistance::Query query(double floor, double resolution) {
  OutsideDistance::Query q;
  q.floor = floor;
  q.resolution = resolution;
  q.ceiling = std::numeric_limits<double>::infinity();
  return q;
}

// Degenerate input.

TEST(OutsideDistance, ABoxWithoutExtent) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  const ConvexHull point = convexHull({{3, 0.5, 0.5}});
  OutsideDistance outside(solid, boundingBox(point));
  const OutsideDistance::Largest largest = outside.largest(point, query(0, 0.01));
  EXPECT_NEAR(largest.found, 2, 0.02);
  EXPECT_GE(largest.bound, 2 - 1e-9);
}

// Closed-form answers.

TEST(OutsideDistance, AFilledChannel) {
  const TriangleMesh mesh = test_shapes::uChannel(1, 1, 0.1, 2, 2);
  const Solid solid = solidOf(mesh);
  const ConvexHull hull = hullOf(mesh);
  OutsideDistance outside(solid, boundingBox(hull));
  const OutsideDistance::Largest largest = outside.largest(hull, query(0, 0.02));
  EXPECT_GE(largest.bound, 0.4 - 1e-9);
  EXPECT_LE(largest.found, 0.4 + 1e-9);
  EXPECT_GE(largest.found, 0.36);
  EXPECT_LE(largest.bound, 0.44);
}

// The distance to a point grows by a cell's whole radius on the way from its centre to the corner that faces away.
TEST(OutsideDistance, TheBoundOfACellHoldsAtItsCorner) {
  TriangleMesh point;
  point.vertices = {{0, 0, 0}};
  point.triangles = {{0, 0, 0}};
  const Solid solid = solidOf(point);
  for (const double resolution : {10.0, 3.0, 1.0}) {
    OutsideDistance outside(solid, {Vector3d(1, 1, 1), Vector3d(9, 9, 9)});
    const ConvexHull corner = boxHull({8.99, 8.99, 8.99}, {9, 9, 9});
    const OutsideDistance::Largest largest = outside.largest(corner, query(0, resolution));
    EXPECT_GE(largest.bound, std::sqrt(243.0));
    EXPECT_LE(largest.bound, std::sqrt(243.0) * 1.001);
    EXPECT_LE(largest.found, std::sqrt(243.0));
    const Vector3d low(8.9, 9, 9), end(9, 9, 9), side(9, 8.9, 9);
    EXPECT_FALSE(outside.isWithin({low, end, side}, std::sqrt(243.0) - 1e-6));
    EXPECT_TRUE(outside.isWithin({low, end, side}, std::sqrt(243.0) * 1.01));
  }
}

// Faces are compared with cells in single precision: a cell that holds a sharp corner, where the hull is furthest, must not seem to miss
// it.
TEST(OutsideDistance, NoCornerIsLostBySinglePrecision) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  RandomPoints random(13);
  for (int i = 0; i < 6; ++i) {
    std::vector<Vector3d> corners;
    for (int k = 0; k < 4; ++k) corners.push_back(Vector3d(4, 3, 2) + random.inCube());
    const ConvexHull hull = convexHull(corners);
    double furthest = 0;
    for (const Vector3d& v : hull.vertices) furthest = std::max(furthest, solid.distance(v));
    OutsideDistance outside(solid, boundingBox(hull));
    EXPECT_GE(outside.largest(hull, query((1 - 1e-8) * furthest, 1e-8)).bound, furthest * (1 - 1e-12)) << i;
  }
}

// A ball, and the cell about a point of its inside: the child towards the surface lies beyond it, and reaches further by its radius.
TEST(OutsideDistance, ACellBeyondTheSurfaceDoesNotInheritTheSide) {
  const Solid solid = solidOf(test_shapes::sphere(10, 16));
  const Eigen::Matrix3d to_world = solid.axes().transpose();
  const Vector3d diagonal = to_world * Vector3d::Constant(1 / std::sqrt(3.0));
  for (double depth = 0.05; depth < 1.8; depth += 0.05) {
    const Vector3d middle = (10 - depth) * diagonal, side = Vector3d::Constant(1);
    const double half = (solid.axes().cwiseAbs() * side).maxCoeff();  // of the root
    const Vector3d corner = middle + 0.999 * half * std::sqrt(3.0) * diagonal;
    OutsideDistance outside(solid, {middle - side, middle + side});
    const ConvexHull speck = boxHull(corner - 1e-6 * side, corner + 1e-6 * side);
    EXPECT_GE(outside.largest(speck, query(0, 0.9 * std::sqrt(3.0) * half)).bound, solid.distance(corner)) << depth;
  }
}

// Cells that the floor dismisses have no side, and may lie outside.
TEST(OutsideDistance, WhatIsDismissedIsNotKnownToBeWithinLess) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  const Vector3d half(0.5, 0.5, 0.5), reach(0.65, 0.65, 0.65);
  OutsideDistance outside(solid, {Vector3d(-half), Vector3d(3 * half)});
  outside.largest(boxHull(half - reach, half + reach), query(0.3, 0.01));
  for (const double y : {0.56, 0.69})
    for (const double z : {0.56, 0.69}) {
      const std::array<Vector3d, 3> beside{Vector3d(1.14, y, z), Vector3d(1.14, y + 0.01, z), Vector3d(1.14, y, z + 0.01)};
      EXPECT_TRUE(outside.isWithin(beside, 0.3));
      EXPECT_FALSE(outside.isWithin(beside, 0.13));
    }
}

// Over a sheet, in a cube that fills the octree's root, distances are at most 0.5. What is known from a search that did not care up to a
// little more is no more than that.
TEST(OutsideDistance, WhatIsLevelWithinADistanceIsNotKnownToBeWithinLess) {
  const Solid solid = solidOf(test_shapes::sheet(4, 4));
  const ConvexHull cube = boxHull({1.9, 1.95, 0.4}, {2.0, 2.05, 0.5});
  OutsideDistance outside(solid, boundingBox(cube));
  for (const double floor : {0.525, 0.485}) {
    OutsideDistance::Query q = query(floor, 1e-3);
    q.summits_only = true;
    EXPECT_GE(outside.largest(cube, q).bound, std::max(floor, 0.5)) << floor;
  }
}

// Inside, a cell reaches out of the solid by its radius less the depth of its centre.
TEST(OutsideDistance, TheBoundOfACellThatReachesOutOfTheSolid) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  OutsideDistance outside(solid, {Vector3d(0.4, 0.4, 0.4), Vector3d(1.4, 1.4, 1.4)});
  const ConvexHull corner = boxHull({1.39, 1.39, 1.39}, {1.4, 1.4, 1.4});
  EXPECT_GE(outside.largest(corner, query(0, 10)).bound, std::sqrt(0.48));
  EXPECT_GE(outside.largest(corner, query(0, 0.3)).bound, std::sqrt(0.48));
}

// The middle of a flask's hollow is 1 from its walls. Cells below divide there along x, but not along y and z, so that the middle lies on
// their border and is the middle of none.

// A hull 0.2 around it is 0.8 from the walls, and the cell's other points are no deeper than its distance from the hull's faces allows.
TEST(OutsideDistance, PointsLieAsDeepInAHullAsItsFacesAllow) {
  const Solid solid = solidOf(test_shapes::flask(0.2, 2));
  const Vector3d middle(0, 0, 1.5), reach = Vector3d::Constant(0.2), off(0, 0.06, 0.05), half = Vector3d::Constant(0.26);
  OutsideDistance outside(solid, {middle + off - half, middle + off + half});
  OutsideDistance::Query q = query(0.8, 0.3);  // the root's eight children are not divided
  q.surface_bound = 0.8;
  const OutsideDistance::Largest largest = outside.largest(boxHull(middle - reach, middle + reach), q);
  EXPECT_LT(largest.found, 0.95);
  EXPECT_GE(largest.bound, 1);
  EXPECT_LE(largest.bound, 1.0001);
}

// A wall is as far from a cell as from its furthest corner.
TEST(OutsideDistance, ACellBesideAWallReachesToItsCorners) {
  const Solid solid = solidOf(test_shapes::flask(0.2, 2));
  const Vector3d middle(0, 0, 1.5), off(0, 0.03, 0.05), half = Vector3d::Constant(0.2);
  OutsideDistance outside(solid, {middle + off - half, middle + off + half});
  OutsideDistance::Query q = query(0.995, 0.05);  // a tenth less than the corners' distance to the wall is below the floor
  q.summits_only = true;
  const OutsideDistance::Largest largest = outside.largest(boxHull(middle + off - 0.95 * half, middle + off + 0.95 * half), q);
  EXPECT_GE(largest.bound, 1 - 1e-12);
  EXPECT_LE(largest.bound, 1.1);
}

// Its cells rotate with the mesh.
TEST(OutsideDistance, ARotatedMesh) {
  Eigen::Isometry3d turn(Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2).normalized());
  OutsideDistance::Largest largest[2];
  std::vector<OutsideDistance::Intruder> intruders[2];
  for (std::size_t turned = 0; turned < 2; ++turned) {
    const TriangleMesh mesh = turned ? transformed(test_shapes::uChannel(), turn) : test_shapes::uChannel();
    const Solid solid = solidOf(mesh);
    OutsideDistance outside(solid, boundingBox(mesh));
    largest[turned] = outside.largest(hullOf(mesh), query(0, 0.01));
    intruders[turned] = outside.intruders(hullOf(mesh), 0.1, 100, 0.01);
    for (const OutsideDistance::Intruder& i : intruders[turned]) EXPECT_GE(solid.distance(i.p), i.distance - 1e-9);
    EXPECT_GE(solid.distance(largest[turned].where), largest[turned].found - 1e-9);
    const Vector3d &a = mesh.vertices[0], &b = mesh.vertices[2];
    EXPECT_TRUE(outside.isWithin({a, a, b}, 0.5));
  }
  EXPECT_NEAR(largest[0].bound, 0.4, 0.02);
  EXPECT_NEAR(largest[1].bound, 0.4, 0.02);
  EXPECT_GT(intruders[1].size(), 90U);
}

TEST(OutsideDistance, KnowsNothingBeyondItsBox) {
  const TriangleMesh mesh = test_shapes::box(1, 1, 1);
  const Solid solid = solidOf(mesh);
  const OutsideDistance outside(solid, boundingBox(mesh));
  EXPECT_TRUE(outside.isWithin({Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}, 2));
  EXPECT_FALSE(outside.isWithin({Vector3d(0, 0, 5), Vector3d(1, 0, 5), Vector3d(0, 1, 5)}, 2));
  EXPECT_FALSE(outside.isWithin({Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 5)}, 2));
  EXPECT_TRUE(outside.reaches(hullOf(mesh)));
  EXPECT_FALSE(outside.reaches(boxHull({0, 0, 0}, {1, 1, 5})));
}

TEST(OutsideDistance, FindsNothingAboveTheFloorQuickly) {
  const TriangleMesh mesh = test_shapes::uChannel(1, 1, 0.1, 2, 2);
  const Solid solid = solidOf(mesh);
  OutsideDistance outside(solid, boundingBox(mesh));
  EXPECT_EQ(outside.largest(hullOf(mesh), query(0.5, 0.01)).bound, 0.5);
}

TEST(OutsideDistance, EndsAtTheCeiling) {
  const TriangleMesh mesh = test_shapes::uChannel(1, 1, 0.1, 2, 2);
  const Solid solid = solidOf(mesh);
  OutsideDistance outside(solid, boundingBox(mesh));
  OutsideDistance::Query q = query(0, 0.01);
  q.ceiling = 0.2;
  const OutsideDistance::Largest largest = outside.largest(hullOf(mesh), q);
  EXPECT_GT(largest.found, 0.2);
  EXPECT_EQ(largest.bound, std::numeric_limits<double>::infinity());
}

TEST(OutsideDistance, SummitsOnly) {
  const TriangleMesh mesh = test_shapes::flask(0.2, 2);
  const Solid solid = solidOf(mesh);
  OutsideDistance outside(solid, boundingBox(mesh));
  OutsideDistance::Query q = query(0.3, 0.01);
  q.summits_only = true;
  const OutsideDistance::Largest summit = outside.largest(hullOf(mesh), q);
  EXPECT_NEAR(summit.found, 1, 0.02);
  EXPECT_GE(summit.bound, 1 - 1e-9);
  // A hull beside the hollow's middle has no summit above the floor.
  EXPECT_EQ(outside.largest(boxHull({-1.4, -1.4, 0.1}, {-0.8, 1.4, 2.9}), q).bound, 0.3);
}

// Random input.

// The middle of the gap is as far from the plate as from the opening below, and only the plate's flat side is as near.
TEST(OutsideDistance, SummitsBetweenAWallAndAnOpening) {
  const double gap = 0.1;
  const Solid solid =
      solidOf(test_shapes::merged({test_shapes::boxWithWindow(0.3), test_shapes::moved(test_shapes::box(1, 1, 0.5), {0, 0, 1 + gap})}));
  ASSERT_TRUE(solid.hasOpenings());
  const ConvexHull hull = boxHull({0.49, 0.49, 1.01}, {0.51, 0.51, 1.12});
  OutsideDistance outside(solid, boundingBox(hull));
  OutsideDistance::Query q = query(0.04, 1e-3);
  q.summits_only = true;
  EXPECT_GE(outside.largest(hull, q).bound, gap / 2 - 1e-9);
}

/// The unit cube without the corner at (1, 1, 1): the surface is open there, across the cells' diagonals.
TriangleMesh cubeWithOpenCorner(double cut) {
  const double r = 1 - cut;
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, r}, {1, r, 1}, {r, 1, 1}};
  for (const std::vector<int>& face :
       {std::vector{0, 2, 4, 1}, {0, 1, 5, 3}, {0, 3, 6, 2}, {1, 4, 7, 8, 5}, {2, 6, 9, 7, 4}, {3, 5, 8, 9, 6}})
    for (std::size_t k = 2; k < face.size(); ++k) mesh.triangles.push_back({face[0], face[k - 1], face[k]});
  return mesh;
}

// In an opening the solid ends in mid air, far from any surface.
TEST(OutsideDistance, CellsInAnOpeningDoNotPassForInside) {
  const Solid solid = solidOf(cubeWithOpenCorner(0.6));
  ASSERT_TRUE(solid.hasOpenings() && solid.contains({0.5, 0.5, 0.5}) && !solid.contains({0.9, 0.9, 0.9}));
  RandomPoints random(3);
  int above = 0, below = 0;
  for (int trial = 0; trial < 40; ++trial) {  // cells lie elsewhere each time
    OutsideDistance outside(solid, {-random.number(0, 0.3) * Vector3d::Ones(), Vector3d(1, 1, 1)});
    for (int i = 0; i < 300; ++i) {
      const Vector3d p = random.number(0.75, 0.9) * Vector3d::Ones() + random.inCube(0.05), half = Vector3d::Constant(1e-3);
      const double bound = outside.largest(boxHull(p - half, p + half), query(0.005, 1e-3)).bound;
      EXPECT_GE(bound, solid.leastDistance(p, solid.distanceToSurface(p))) << p.transpose();
      ++(bound > 0.005 ? above : below);
    }
  }
  EXPECT_GT(above, 3000);
  EXPECT_GT(below, 1000);
}

TEST(OutsideDistance, FoundAndBoundEncloseTheSamples) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const TriangleMesh mesh = seed % 3 == 0   ? test_shapes::torus(1, 0.3, 16, 8)
                              : seed % 3 == 1 ? test_shapes::openBox(1, 1, 1, 0.05, 2)
                                              : random.soup(20, 0.4);
    const Solid solid = solidOf(mesh);
    Eigen::AlignedBox3d box = boundingBox(mesh);
    OutsideDistance outside(solid, box);
    for (int h = 0; h < 5; ++h) {
      std::vector<Vector3d> points;
      for (int i = 0; i < 6; ++i) points.push_back(random.inBox(box));
      const ConvexHull hull = convexHull(points);
      const OutsideDistance::Largest largest = outside.largest(hull, query(0.05, 0.05));
      EXPECT_LE(largest.found, largest.bound);
      if (largest.found > 0) {
        EXPECT_LE(planeDistance(hull, largest.where), 1e-9);
        EXPECT_GE(solid.distance(largest.where), largest.found - 1e-9);
      }
      for (int i = 0; i < 500; ++i) EXPECT_LE(solid.distance(inHull(hull, random)), largest.bound + 1e-12);
    }
  }
}

// Bounds get tighter with each query, yet hold: those of all points, and those of summits.
TEST(OutsideDistance, WhatQueriesLeaveBehindSparesLaterOnes) {
  const TriangleMesh mesh = test_shapes::flask(0.2, 2);
  const Solid solid = solidOf(mesh);
  const ConvexHull hull = hullOf(mesh);
  for (const bool summits_only : {false, true}) {
    OutsideDistance outside(solid, boundingBox(mesh));
    OutsideDistance::Query q = query(0.3, 0.02);
    q.summits_only = summits_only;
    const OutsideDistance::Largest first = outside.largest(hull, q), again = outside.largest(hull, q);
    EXPECT_LE(again.visits, first.visits);
    EXPECT_LE(again.bound, first.bound);
    EXPECT_GE(again.bound, 1 - 1e-9);
    q.floor = 1.1;
    OutsideDistance settled(solid, boundingBox(mesh));
    EXPECT_GT(settled.largest(hull, q).visits, 0U);
    EXPECT_EQ(settled.largest(hull, q).visits, 0U);  // the root is known to hold nothing above the floor
    q.floor = 0.3;
    EXPECT_GE(settled.largest(hull, q).bound, 1 - 1e-9);
  }
}

TEST(OutsideDistance, BoundsHoldAfterOtherQueries) {
  RandomPoints random(5);
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 16, 8);
  const Solid solid = solidOf(mesh);
  OutsideDistance outside(solid, boundingBox(mesh));
  for (int h = 0; h < 40; ++h) {
    std::vector<Vector3d> points;
    for (int i = 0; i < 6; ++i) points.push_back(random.inBox(boundingBox(mesh)));
    const ConvexHull hull = convexHull(points);
    OutsideDistance::Query q = query(h % 2 == 0 ? 0.1 : 0.3, h % 3 == 0 ? 0.02 : 0.1);
    q.summits_only = h % 4 == 1;
    const double bound = outside.largest(hull, q).bound;
    if (q.summits_only) continue;
    for (int i = 0; i < 300; ++i) EXPECT_LE(solid.distance(inHull(hull, random)), bound + 1e-12);
  }
}

TEST(OutsideDistance, LearnsFromAnotherAboutAPart) {
  const TriangleMesh mesh = test_shapes::uChannel(1, 1, 0.1, 2, 2);
  const Solid solid = solidOf(mesh);
  OutsideDistance teacher(solid, boundingBox(mesh)), whole(solid, boundingBox(mesh)), part(solid, boundingBox(mesh));
  const OutsideDistance::Largest largest = teacher.largest(hullOf(mesh), query(0, 0.02));
  whole.learn(teacher, boundingBox(mesh));
  part.learn(teacher, {Vector3d(0, 0, 0), Vector3d(1, 1, 0.2)});
  const std::array<Vector3d, 3> low{Vector3d(0.4, 0.6, 0.1), {0.6, 0.6, 0.1}, {0.5, 0.8, 0.1}};
  std::array<Vector3d, 3> high = low;
  for (Vector3d& p : high) p.z() += 1.8;
  const double enough = largest.bound + 0.02;
  for (const auto& triangle : {low, high}) {
    EXPECT_TRUE(teacher.isWithin(triangle, enough));
    EXPECT_TRUE(whole.isWithin(triangle, enough));
  }
  EXPECT_TRUE(part.isWithin(low, enough));
  EXPECT_FALSE(part.isWithin(high, enough));
  for (OutsideDistance* learned : {&whole, &part}) {
    const OutsideDistance::Largest again = learned->largest(hullOf(mesh), query(0, 0.02));
    EXPECT_EQ(again.where, largest.where);
    EXPECT_LE(again.bound, largest.bound);
    EXPECT_GE(again.bound, 0.4 - 1e-9);
    EXPECT_LE(again.visits, largest.visits);
  }
}

TEST(OutsideDistance, IntrudersAreInTheHullAndFarFromTheSolid) {
  const TriangleMesh mesh = test_shapes::openBox(1, 1, 1, 0.05, 3);
  const Solid solid = solidOf(mesh);
  const ConvexHull hull = hullOf(mesh);
  OutsideDistance outside(solid, boundingBox(mesh));
  const auto intruders = outside.intruders(hull, 0.1, 50, 0.01);
  EXPECT_GE(intruders.size(), 50u);
  double volume = 0;
  for (const OutsideDistance::Intruder& i : intruders) {
    EXPECT_LE(planeDistance(hull, i.p), 1e-9);
    EXPECT_GT(i.distance, 0.1);
    EXPECT_GE(solid.distance(i.p), i.distance - 1e-9);
    EXPECT_EQ(i.weight, intruders[0].weight);
    volume += i.weight;
  }
  EXPECT_NEAR(volume, 0.7 * 0.7 * 0.85, 0.25);
  EXPECT_TRUE(outside.intruders(hull, 0.5, 50, 0.01).empty());
  EXPECT_TRUE(outside.intruders(boxHull({0, 0, 0}, {1, 1, 0.05}), 0.01, 50, 0.01).empty());
}

}  // namespace
}  // namespace collision_hulls
