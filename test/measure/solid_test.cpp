#include "collision_hulls/measure/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/measure/measures.h"
#include "measure/walls.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::OpenMesh;
using test_shapes::openMeshes;
using test_shapes::RandomPoints;
using test_shapes::solidOf;
using test_shapes::withoutSummit;

constexpr double kBlur = 1e-9;  // of the extent: how much smaller balls inside are than they might be

// Degenerate input.

TEST(Solid, TrianglesWithoutAreaAreTheirCorners) {
  const Solid solid = solidOf({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(solid.volume(), 0);
  EXPECT_FALSE(solid.contains({1, 0, 0}));
  EXPECT_NEAR(solid.distance({2, 3, 4}), 5, 1e-12);
  EXPECT_FALSE(withoutSummit(solid, {1, 1, 1}, 0.1));
}

TEST(Solid, LoosePointsArePartOfTheSurface) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  mesh.vertices.push_back({5, 5, 5});
  mesh.triangles.push_back({8, 8, 8});
  const Solid solid = solidOf(mesh);
  EXPECT_NEAR(solid.distance({5, 5, 6}), 1, 1e-12);
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
}

// Closed-form answers.

TEST(Solid, Box) {
  const Solid solid = solidOf(test_shapes::box(1, 2, 3, 4));
  EXPECT_EQ(solid.interior(), Interior::kClosed);
  EXPECT_NEAR(solid.volume(), 6, 1e-12);
  EXPECT_TRUE(solid.contains({0.5, 1, 1.5}));
  EXPECT_FALSE(solid.contains({1.5, 1, 1.5}));
  EXPECT_EQ(solid.distance({0.5, 1, 1.5}), 0);
  EXPECT_NEAR(solid.distanceToSurface({0.5, 1, 1.5}), 0.5, 1e-12);
  EXPECT_NEAR(solid.distance({4, 6, 1}), 5, 1e-12);
}

TEST(Solid, ABoxInsideOutIsABox) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1, 2);
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  const Solid solid = solidOf(mesh);
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_NEAR(solid.volume(), 1, 1e-12);
}

TEST(Solid, AClosedCavityIsInside) {
  TriangleMesh cavity = test_shapes::moved(test_shapes::box(0.4, 0.4, 0.4), {0.3, 0.3, 0.3});
  for (Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  const Solid solid = solidOf(test_shapes::merged({test_shapes::box(1, 1, 1), cavity}));
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({0.1, 0.1, 0.1}));
  EXPECT_EQ(solid.distance({0.5, 0.5, 0.5}), 0);
}

TEST(Solid, AnOpenVesselIsHollow) {
  const Solid box = solidOf(test_shapes::openBox()), flask = solidOf(test_shapes::flask());
  EXPECT_NEAR(box.volume(), 1 - 0.9 * 0.9 * 0.95, 1e-12);
  EXPECT_NEAR(box.distance({0.5, 0.5, 0.55}), 0.45, 1e-12);
  EXPECT_NEAR(flask.volume(), 27 - 8 - 0.16 * 0.5, 1e-12);
  EXPECT_NEAR(flask.distance({0, 0, 1.5}), 1, 1e-12);
}

TEST(Solid, ASheetHasNoInside) {
  const Solid solid = solidOf(test_shapes::sheet(1, 1, 3));
  EXPECT_EQ(solid.interior(), Interior::kSurface);
  EXPECT_EQ(solid.volume(), 0);
  EXPECT_NEAR(solid.distance({0.5, 0.5, 0.25}), 0.25, 1e-12);
  EXPECT_NEAR(solid.distance({0.5, 0.5, -0.25}), 0.25, 1e-12);
  EXPECT_FALSE(withoutSummit(solid, {0.5, 0.5, 0.25}, 0.01));
}

TEST(Solid, ASmallWindowLeavesAnInside) {
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  EXPECT_EQ(solid.interior(), Interior::kWinding);
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.95}));
  EXPECT_FALSE(solid.contains({0.5, 0.5, 1.05}));
  EXPECT_FALSE(solid.contains({0.5, 0.5, -0.05}));
}

TEST(Solid, APartitionInsideABoxChangesNothingOutside) {
  // Three triangles meet at the partition's edges: the surface is closed, but counting crossings cannot tell what it encloses.
  for (bool up : {true, false}) {
    TriangleMesh partition = test_shapes::moved(test_shapes::sheet(1, 1, 1), {0, 0, 0.5});
    if (!up)
      for (Triangle& t : partition.triangles) std::swap(t[0], t[1]);
    TriangleMesh walls = test_shapes::squareVessel({{0.5, 0}, {0.5, 0.5}, {0.5, 1}});
    const Solid solid = solidOf(test_shapes::merged({test_shapes::moved(walls, {0.5, 0.5, 0}), partition}));
    EXPECT_FALSE(solid.contains({0.5, 0.5, -0.1}));
    EXPECT_FALSE(solid.contains({0.4, 0.3, 1.1}));
    EXPECT_FALSE(solid.contains({0.4, 0.3, -2}));
    EXPECT_TRUE(solid.contains({0.5, 0.5, 0.1}));
    EXPECT_TRUE(solid.contains({0.5, 0.5, 0.9}));
  }
}

/// Adjacent unit cubes with all of their walls, each cube the mirror image of its neighbours: the same triangles make up both sides of a
/// shared wall.
TriangleMesh cubes(int x, int y) {
  std::vector<TriangleMesh> all;
  for (int i = 0; i < x; ++i)
    for (int j = 0; j < y; ++j) {
      TriangleMesh cube = test_shapes::box(1, 1, 1);
      for (Vector3d& v : cube.vertices) v += Vector3d(i % 2 ? i + 1 - 2 * v.x() : i, j % 2 ? j + 1 - 2 * v.y() : j, 0);
      if ((i + j) % 2)
        for (Triangle& t : cube.triangles) std::swap(t[0], t[1]);
      all.push_back(cube);
    }
  return test_shapes::merged(all);
}

TEST(Solid, WallsSharedBySolidsEncloseNothing) {
  for (const auto& [x, y] : {std::pair(2, 1), std::pair(5, 1), std::pair(2, 2), std::pair(3, 3)}) {
    const Solid solid = solidOf(cubes(x, y));
    EXPECT_FALSE(solid.hasOpenings());
    EXPECT_EQ(solid.interior(), Interior::kClosed);
    EXPECT_NEAR(solid.volume(), x * y, 1e-12);
    for (const double step : {-0.02, 0.02}) EXPECT_TRUE(solid.contains({1 + step, 0.4, 0.6})) << x << " by " << y;
    EXPECT_FALSE(solid.contains({0.5, 0.4, 1.02}));
    EXPECT_LE(protrusion({test_shapes::boxHull({0, 0, 0}, Vector3d(x, y, 1))}, solid, 1e-4).found, 1e-12);
  }
}

TEST(Solid, TrianglesThatAllFaceBothWaysStillEncloseASolid) {
  TriangleMesh mesh = cubes(2, 2);
  const std::size_t triangles = mesh.triangles.size();
  for (std::size_t t = 0; t < triangles; ++t) mesh.triangles.push_back({mesh.triangles[t][0], mesh.triangles[t][2], mesh.triangles[t][1]});
  EXPECT_TRUE(solidOf(mesh).contains({0.5, 0.4, 0.6}));
}

TEST(Solid, AnOpenMeshContainsWhatItsWindingNumberSays) {
  for (const OpenMesh& open : openMeshes()) {
    const TriangleMesh& mesh = open.mesh;
    const Solid solid = solidOf(mesh);
    const TriangleBvh winding(mesh);
    RandomPoints random(3);
    int near = 0;
    for (std::size_t i = 0; i < 20'000; ++i) {
      const Vector3d p = i % 2 == 0 ? random.inBox(boundingBox(mesh)) : mesh.vertices[i % mesh.vertices.size()] + random.inCube(0.1);
      const double number = winding.windingNumber(p), away = std::abs(number - 0.55);
      if (away < 2 * TriangleBvh::kWindingError) continue;
      EXPECT_EQ(solid.contains(p), number > 0.55) << number;
      near += away < 0.1;
    }
    EXPECT_GT(near, 15);
  }
}

TEST(Solid, TheSignedDistanceStaysInside) {
  for (const auto& [mesh, ball] : openMeshes()) {
    const Solid solid = solidOf(mesh);
    ASSERT_TRUE(solid.hasOpenings());
    RandomPoints random(1);
    double largest = 0;
    for (int i = 0; i < 500; ++i) {
      const Vector3d p = random.inBox(boundingBox(mesh));
      const double to_surface = solid.distanceToSurface(p), d = solid.signedDistance(p, to_surface);
      EXPECT_EQ(d > 0, !solid.contains(p) && to_surface > 0);
      EXPECT_LE(-d, to_surface);
      if (d > 0) continue;
      largest = std::max(largest, -d);
      for (int k = 0; k < 20; ++k) EXPECT_TRUE(solid.contains(p - 0.999 * std::min(d, 0.0) * random.onSphere())) << p.transpose();
    }
    EXPECT_GT(largest, ball);
  }
  const Solid closed = solidOf(test_shapes::box(1, 1, 1));
  EXPECT_FALSE(closed.hasOpenings());
  EXPECT_NEAR(closed.signedDistance({0.5, 0.5, 0.5}, 0.5), -0.5, 2 * kBlur);
  EXPECT_GT(closed.signedDistance({0.5, 0.5, 0.5}, 0.5), -0.5);
  EXPECT_EQ(closed.signedDistance({0.5, 0.5, 1.5}, 0.5), 0.5);
}

// Where the side is known, the ball is no larger.
TEST(Solid, TheSignedDistanceOfAKnownSideIsTheSame) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  RandomPoints random(5);
  for (int i = 0; i < 200; ++i) {
    const Vector3d p = Vector3d::Constant(0.5) + random.inCube(0.9);
    const double to_surface = solid.distanceToSurface(p);
    EXPECT_EQ(solid.signedDistance(p, to_surface, solid.contains(p)), solid.signedDistance(p, to_surface));
  }
  EXPECT_GE(solid.signedDistance({0.5, 0.5, 0.75}, 0.25, true), -0.25 + kBlur * (1 - 1e-6));
}

// A sheet inside has the solid on both sides.
TEST(Solid, TheBallInsideReachesPastSheets) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  mesh = test_shapes::merged({mesh, {{{0.2, 0.2, 0.45}, {0.8, 0.2, 0.45}, {0.5, 0.8, 0.45}}, {{0, 1, 2}}}});
  const Solid solid = solidOf(mesh);
  const Vector3d middle(0.5, 0.5, 0.5);
  EXPECT_NEAR(solid.distanceToSurface(middle), 0.05, 1e-12);
  EXPECT_NEAR(solid.signedDistance(middle, 0.05), -0.5, 2 * kBlur);
  EXPECT_EQ(solid.signedDistance(middle, 0.05, true), solid.signedDistance(middle, 0.05));
  EXPECT_EQ(solid.signedDistance({0.5, 0.5, 1.05}, 0.05), 0.05);
}

// A ray that counts crossings starts a little aside, possibly across a wall.
TEST(Solid, WhatLiesWithinTheBlurOfTheSurfaceCountsAsOutside) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  for (const Vector3d& normal : {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)})
    for (const double height : {-0.9 * kBlur, -0.3 * kBlur, 0.0, 0.3 * kBlur}) {
      const Vector3d p = Vector3d(0.5, 0.5, 0.5) + (0.5 + height) * normal;
      const double to_surface = solid.distanceToSurface(p);
      EXPECT_EQ(solid.signedDistance(p, to_surface), to_surface);
    }
  const Vector3d p(0.5, 0.5, 0.7);
  EXPECT_FALSE(solid.isOneSide(p, 0.5 * kBlur, 0));
  EXPECT_FALSE(solid.isOneSide(p, 0.3, 0.3)) << "the other side begins just beyond the wall";
  EXPECT_TRUE(solid.isOneSide(p, 0.3, 0.2999));
}

bool isOneSide(const Solid& solid, const std::array<Vector3d, 3>& patch, const std::array<Vector3d, 3>** met = nullptr) {
  Winding centre = solid.windingAt((patch[0] + patch[1] + patch[2]) / 3);
  return solid.isOneSide(patch, centre, met);
}

// With openings, S also ends in mid air.
TEST(Solid, APatchOnOneSideIsOnOneSideEverywhere) {
  RandomPoints random(4);
  for (const TriangleMesh& mesh :
       {test_shapes::openBox(1, 1, 1, 0.1, 3), test_shapes::torus(1, 0.3, 16, 10), test_shapes::boxWithWindow(0.2)}) {
    const Solid solid = solidOf(mesh);
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    int inside = 0, mixed = 0;
    for (int trial = 0; trial < 1500; ++trial) {
      const Vector3d p = random.inBox(box);
      const double size = std::pow(10.0, random.number(-2, 0));
      const std::array<Vector3d, 3> patch{p + random.inCube(size), p + random.inCube(size), p + random.inCube(size)};
      const bool first = solid.contains((patch[0] + patch[1] + patch[2]) / 3);
      bool alike = true;
      for (int k = 0; k < 50; ++k) alike = alike && solid.contains(random.inTriangle(patch[0], patch[1], patch[2])) == first;
      const std::array<Vector3d, 3>* met = nullptr;
      const bool claimed = isOneSide(solid, patch, &met);
      EXPECT_TRUE(alike || !claimed) << p.transpose() << ", size " << size;
      EXPECT_TRUE(!met || !claimed);
      inside += claimed && first;
      mixed += !alike;
    }
    EXPECT_GT(inside, 50);
    EXPECT_GT(mixed, 50);
  }
}

// Straight out of a wall, or of a window, the distance grows by the whole way, or nearly so.
TEST(Solid, TheDistanceWithinABallIsThatOfItsFurthestPoint) {
  const auto within = [](const Solid& solid, const Vector3d& p, double radius) {
    const double to_surface = solid.distanceToSurface(p);
    return solid.distanceWithin(radius, solid.signedDistance(p, to_surface), to_surface);
  };
  const Vector3d up = Vector3d::UnitZ();
  const Solid box = solidOf(test_shapes::box(1, 1, 1)), open = solidOf(test_shapes::boxWithWindow(0.2));
  for (const double radius : {0.15, 0.5, 2.0, 10.0}) {  // just out of the window, where the surface is far, and far away
    for (const double z : {0.6, 0.9, 1.2}) {
      const Vector3d p(0.5, 0.5, z);
      EXPECT_GE(within(box, p, radius), box.distance(p + radius * up)) << z << ", radius " << radius;
      EXPECT_NEAR(within(box, p, radius), std::max(0.0, z + radius - 1), 3 * kBlur);
      EXPECT_GE(within(open, p, radius), open.distance(p + radius * up)) << z << ", radius " << radius;
      EXPECT_LE(within(open, p, radius), open.distanceToSurface(p) + radius);
    }
  }
}

// What the field of the rim may do further from a patch's middle than the way to the border is unknown.
TEST(Solid, APatchInFrontOfAnOpeningReachesNoFurtherThanTheWayToTheBorder) {
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  for (const double height : {0.4, 0.5, 0.6}) {
    const Vector3d middle(0.5, 0.5, height);
    const double way = solid.wayToBorder(middle);
    ASSERT_GT(way, 0.05);
    const auto patch = [&](double reach) {
      const auto at = [&](double degrees) {
        const double angle = degrees * test_shapes::kPi / 180;
        return Vector3d(middle + reach * Vector3d(std::cos(angle), std::sin(angle), 0));
      };
      return std::array<Vector3d, 3>{at(0), at(120), at(240)};
    };
    EXPECT_TRUE(isOneSide(solid, patch(0.6 * way))) << height;
    EXPECT_FALSE(isOneSide(solid, patch(1.001 * way))) << height;
  }
}

TEST(Solid, FinsDoNotAffectTheInside) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  for (int side = 0; side < 2; ++side) {
    const auto y = static_cast<double>(side);
    mesh = test_shapes::merged({mesh, {{{0, y, 1}, {1, y, 1}, {1, y, 1.4}, {0, y, 1.4}}, {{0, 1, 2}, {0, 2, 3}}}});
  }
  const Solid solid = solidOf(mesh);
  EXPECT_FALSE(solid.hasOpenings());
  for (const double z : {0.01, 0.5, 0.99, 0.999})
    for (const double y : {0.001, 0.01, 0.5, 0.99}) EXPECT_TRUE(solid.contains({0.5, y, z}));
  for (const double z : {1.01, 1.2, 1.39})
    for (const double y : {-0.01, 0.01, 0.5, 0.99, 1.01}) EXPECT_FALSE(solid.contains({0.5, y, z}));
  EXPECT_NEAR(solid.distance({0.5, 0.5, 1.3}), 0.3, 1e-12);
  EXPECT_NEAR(solid.distance({0.5, 0.1, 1.3}), 0.1, 1e-12);  // to a fin
  EXPECT_DOUBLE_EQ(solid.volume(), 1);
}

TEST(Solid, NoPathToABorderIsShorterThanTheBound) {
  const TriangleMesh mesh = test_shapes::boxWithWindow(0.2);
  const Solid solid = solidOf(mesh);
  RandomPoints random(1);
  double largest = 0;
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = Vector3d(0.5, 0.5, 1) + random.inCube(0.2);
    const double way = solid.wayToBorder(p);
    const bool inside = solid.contains(p);
    largest = std::max(largest, way);
    for (int k = 0; k < 20; ++k) {  // straight paths through the window: the border separates their ends
      const Vector3d through(0.5 + random.number(-0.2, 0.2), 0.5 + random.number(-0.2, 0.2), 1);
      const Vector3d end = through + random.number(0, 0.5) * (through - p);
      if (solid.contains(end) == inside) continue;
      EXPECT_GE((end - p).norm(), way);
      ++met;
    }
  }
  EXPECT_GT(largest, 0.05);
  EXPECT_GT(met, 1000);
  EXPECT_TRUE(std::isinf(solidOf(test_shapes::box(1, 1, 1)).wayToBorder({0.5, 0.5, 0.5})));
}

// A ball about a place below a window meets no surface, but reaches above the window, where it is outside.
TEST(Solid, NoBallIsOnOneSideThatReachesThroughAnOpening) {
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2)), closed = solidOf(test_shapes::box(1, 1, 1));
  const Vector3d below(0.5, 0.5, 0.9), above(0.5, 0.5, 1.1);
  ASSERT_TRUE(solid.contains(below) && !solid.contains(above));
  ASSERT_GT(solid.distanceToSurface(below), (above - below).norm());
  EXPECT_FALSE(solid.isOneSide(below, solid.distanceToSurface(below), (above - below).norm()));
  EXPECT_TRUE(closed.isOneSide(below, 0.3, 0.2)) << "so that the test can tell";
}

TEST(Solid, ABallOnOneSideIsOnOneSideEverywhere) {
  RandomPoints random(5);
  for (const TriangleMesh& mesh : {test_shapes::openBox(1, 1, 1, 0.1, 3), test_shapes::boxWithWindow(0.2)}) {
    const Solid solid = solidOf(mesh);
    int inside = 0, outside = 0;
    for (int trial = 0; trial < 1500; ++trial) {
      const Vector3d p = Vector3d(0.5, 0.5, 0.5) + random.inCube(1.2);
      const double to_surface = solid.distanceToSurface(p), radius = to_surface * random.number(0, 1.2);
      if (!solid.isOneSide(p, to_surface, radius)) continue;
      const bool side = solid.contains(p);
      for (int k = 0; k < 50; ++k)
        EXPECT_EQ(solid.contains(p + radius * random.onSphere()), side) << p.transpose() << ", radius " << radius;
      ++(side ? inside : outside);
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(outside, 200);
  }
}

// On the axis of a round opening of radius a, at a height h below it, the winding number is 1/2 + h / (2 sqrt(h^2 + a^2)). The rim's field
// bounds how fast it changes, and what stands for the rim is twice as strong at most.
TEST(Solid, TheWayOutOfARoundOpeningIsThatOfTheRimsField) {
  const double a = 0.15;
  TriangleMesh mesh = test_shapes::sphere(1, 40);
  for (Vector3d& v : mesh.vertices)  // those about the pole move to the opening's rim
    if (v.head<2>().norm() < a + 0.04 && v.z() > 0) v.head<2>() *= std::max(1.0, a / std::max(v.head<2>().norm(), 1e-9)), v.z() = 1;
  std::vector<Triangle> kept;
  const auto isInside = [&](int v) {
    const Vector3d& p = mesh.vertices[static_cast<std::size_t>(v)];
    return p.z() == 1 && p.head<2>().norm() <= a * 1.0001;
  };
  for (const Triangle& t : mesh.triangles)
    if (!isInside(t[0]) || !isInside(t[1]) || !isInside(t[2])) kept.push_back(t);
  mesh.triangles = kept;
  const Solid solid = solidOf(mesh);
  ASSERT_TRUE(solid.hasOpenings());
  for (const double h : {0.05, 0.1, 0.2, 0.4, 0.8}) {
    const Vector3d p(0, 0, 1 - h);
    const double d = std::hypot(h, a), margin = h / (2 * d) - 0.05 - 0.02, k = a / (2 * margin);
    const double way = solid.wayToBorder(p);
    if (margin <= 0) {
      EXPECT_EQ(way, 0);
    } else {
      EXPECT_LE(k * way, 1.05 * d * (d - way)) << h;
      EXPECT_GE(2 * k * way, d * (d - way)) << h;
    }
  }
}

TEST(Solid, OverlappingComponentsAreOneSolid) {
  const Solid solid =
      solidOf(test_shapes::merged({test_shapes::box(1, 1, 1), test_shapes::moved(test_shapes::box(1, 1, 1), {0.5, 0.25, 0.25})}));
  EXPECT_TRUE(solid.contains({0.75, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({1.2, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({0.2, 0.5, 0.5}));
  EXPECT_FALSE(solid.contains({1.2, 0.1, 0.1}));
}

TEST(Solid, FarFromTheOriginAndTiny) {
  const Solid far = solidOf(test_shapes::moved(test_shapes::openBox(), {1e6, 1e6, 1e6}));
  EXPECT_NEAR(far.distance(Vector3d(0.5, 0.5, 0.55) + Vector3d::Constant(1e6)), 0.45, 1e-8);
  const Solid tiny = solidOf(scaled(test_shapes::openBox(), Vector3d::Constant(1e-9)));
  EXPECT_NEAR(tiny.distance(1e-9 * Vector3d(0.5, 0.5, 0.55)), 0.45e-9, 1e-20);
}

}  // namespace
}  // namespace collision_hulls
