#include "measure/surface_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "random_points.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

/// A hull 0.1 around a cube: its corners are 0.1 sqrt(3) away.
class AroundACube : public testing::Test {
 protected:
  Protrusion search(const SurfaceQuery& query) { return largestOnSurface(hull, solid, query, {}); }
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  const ConvexHull hull = boxHull({-0.1, -0.1, -0.1}, {1.1, 1.1, 1.1});
  const double corner = 0.1 * std::sqrt(3.0);
};

TEST_F(AroundACube, TheCornersAreFurthest) {
  SurfaceQuery query;
  query.gap = 1e-3;
  const Protrusion p = search(query);
  EXPECT_NEAR(p.found, corner, 1e-12);
  EXPECT_GE(p.bound, corner);
  EXPECT_LE(p.bound, corner + query.gap);
}

// Below the floor nothing is found, and yet the bound holds: for patches of which the distance is computed, and for patches that an octree
// knows.
TEST_F(AroundACube, ThereIsABoundBelowTheFloor) {
  OutsideDistance octree(solid, boundingBox(hull));
  OutsideDistance::Query fill;
  fill.ceiling = std::numeric_limits<double>::infinity();
  fill.resolution = 0.01;
  octree.largest(hull, fill);
  SurfaceQuery query;
  query.gap = 0.01;
  query.floor = 0.2;
  for (const OutsideDistance* known : {static_cast<const OutsideDistance*>(nullptr), static_cast<const OutsideDistance*>(&octree)}) {
    query.known = known;
    const Protrusion p = search(query);
    EXPECT_EQ(p.found, 0);
    EXPECT_GE(p.bound, corner);
    EXPECT_LE(p.bound, query.floor + query.gap);
  }
}

// What the octree knows to be hardly further than floor and gap is searched all the same: here that is the corners.
TEST_F(AroundACube, WhatIsKnownToBeWithinALittleMoreIsSearched) {
  OutsideDistance octree(solid, boundingBox(hull));
  OutsideDistance::Query fill;
  fill.ceiling = std::numeric_limits<double>::infinity();
  fill.floor = 0.12;
  fill.resolution = 0.002;
  octree.largest(hull, fill);
  SurfaceQuery query;
  query.gap = 0.01;
  query.floor = 0.155;
  query.known = &octree;
  EXPECT_GE(search(query).bound, corner);
}

TEST_F(AroundACube, SettledTrianglesAreSkippedAndCountWithFloorAndGap) {
  SurfaceQuery query;
  query.gap = 0.01;
  query.floor = 0.02;
  const std::vector<char> all(hull.triangles.size(), 1);
  std::vector<char> but_one = all;
  but_one[5] = 0;
  query.settled = &all;
  EXPECT_EQ(search(query).found, 0);
  EXPECT_EQ(search(query).bound, query.floor + query.gap);
  query.settled = &but_one;
  EXPECT_NEAR(search(query).found, corner, 1e-12);
}

TEST_F(AroundACube, TheCeilingEndsTheSearchWithoutABound) {
  SurfaceQuery query;
  query.gap = 1e-3;
  query.ceiling = 0.15;
  EXPECT_GT(search(query).found, 0.15);
  EXPECT_TRUE(std::isinf(search(query).bound));
  query.ceiling = 0.18;
  EXPECT_FALSE(std::isinf(search(query).bound));
}

TEST_F(AroundACube, HalvingsThatRunOutLeaveTheBoundOfTheOpenPatches) {
  const ConvexHull flat =
      boxHull({-2, 0.3, 0.3}, {3, 0.4, 0.4});  // enters at the middle of two walls, so the middles of patches are inside
  SurfaceQuery query;
  query.gap = 1e-3;
  query.halvings = 0;
  const Protrusion p = largestOnSurface(flat, solid, query, {});
  EXPECT_GE(p.bound, 2);
  EXPECT_LE(p.found, 2 + 1e-12);
}

// Where the ceiling is the floor, parts of a hull are searched in parallel.

/// A ball 0.01 around the unit ball, with a vertex pulled out to a distance of 1. Before the triangles at the spike
/// come a share of the others.
ConvexHull ballWithSpike(double before) {
  std::vector<Vector3d> points = test_shapes::sphere(1.01, 3).vertices;
  points[40] *= 2 / 1.01;
  ConvexHull hull = convexHull(points);
  const auto is_at_spike = [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) { return hull.vertices[static_cast<std::size_t>(v)] == points[40]; });
  };
  const auto calm = std::stable_partition(hull.triangles.begin(), hull.triangles.end(), is_at_spike);
  const auto others = static_cast<double>(hull.triangles.end() - calm);
  std::rotate(hull.triangles.begin(), calm, calm + static_cast<std::ptrdiff_t>(before * others));
  return hull;
}

class PartsOfABall : public testing::Test {
 protected:
  Protrusion above(double floor, const ConvexHull& hull) {
    SurfaceQuery query;
    query.gap = 1e-3;
    query.floor = query.ceiling = floor;
    return largestOnSurface(hull, solid, query, {});
  }
  const Solid solid = solidOf(test_shapes::sphere(1, 5));
  const std::vector<double> shares{0, 0.2, 0.4, 0.6, 0.8, 1};
};

TEST_F(PartsOfABall, ASpikeIsFoundInWhicheverPart) {
  for (const double before : shares) {
    const Protrusion p = above(0.1, ballWithSpike(before));
    EXPECT_GT(p.found, 0.1) << before;
    EXPECT_NEAR(solid.distance(p.where), p.found, 1e-9) << before;
    EXPECT_TRUE(std::isinf(p.bound)) << before;
  }
}

TEST_F(PartsOfABall, TheBoundIsThatOfTheWorstPart) {
  for (const double before : shares) {
    const Protrusion p = above(1.5, ballWithSpike(before));
    EXPECT_EQ(p.found, 0) << before;
    EXPECT_GE(p.bound, 1) << before;
    EXPECT_LE(p.bound, 1.501) << before;
  }
}

// Everything is above the ceiling, so that every part finds something.
TEST_F(PartsOfABall, TheFirstPartAnswersOnAnyNumberOfThreads) {
  const ConvexHull hull = ballWithSpike(0.6);
  Protrusion alone;
  withJobs(1, [&] { alone = above(0.005, hull); });
  EXPECT_GT(alone.found, 0.005);
  EXPECT_LT(alone.found, 0.1) << "the spike is in a later part";
  for (int i = 0; i < 200; ++i) {
    const Protrusion p = above(0.005, hull);
    EXPECT_EQ(p.found, alone.found);
    EXPECT_EQ(p.where, alone.where);
  }
}

// Patches are moved into the solid.

/// The search's bound before anything is divided.
double firstBound(const ConvexHull& hull, const Solid& solid, double floor) {
  SurfaceQuery query;
  query.floor = floor;
  query.gap = 1e-3;
  query.halvings = 0;
  return largestOnSurface(hull, solid, query, {}).bound;
}

TEST(SurfaceSearch, AFaceThroughTheSolidIsSettledWhole) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1, 8));
  EXPECT_LE(firstBound(boxHull({0, 0.4, 0.4}, {1, 0.6, 0.6}), solid, 0.05), 0.051) << "it ends at two walls";
  EXPECT_LE(firstBound(boxHull({-0.02, 0.4, 0.4}, {1.02, 0.6, 0.6}), solid, 0.05), 0.051) << "it ends beyond them";
  EXPECT_GT(firstBound(boxHull({-0.07, 0.4, 0.4}, {1.07, 0.6, 0.6}), solid, 0.05), 0.069);
}

// Two corners stick out of opposite walls; to be moved inside they have to go as far, at least.
TEST(SurfaceSearch, WhatIsMovedInsideIsWithinTheWayThatItWasMoved) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  const double out = 0.05;
  SurfaceQuery query;
  query.gap = 1e-4;
  query.halvings = 0;
  for (const double floor : {1.005, 1.02, 1.05}) {
    query.floor = floor * out;
    const Protrusion p = largestOnSurface({{-out, 0.5, 0.5}, {1 + out, 0.5, 0.5}, {0.5, 0.6, 0.5}}, {{0, 1, 2}}, solid, query, {});
    EXPECT_GE(p.bound, out);
    EXPECT_LE(p.bound, query.floor + query.gap);
    EXPECT_EQ(p.found, 0);
  }
}

TEST(SurfaceSearch, AFaceNearARoundSurfaceIsSettledWhole) {
  const Solid solid = solidOf(test_shapes::sphere(1, 5));
  const ConvexHull hull = boxHull({-0.2, -0.2, 0.9}, {0.2, 0.2, 1});
  const double corner = std::sqrt(1.08) - 1;
  EXPECT_LE(firstBound(hull, solid, 0.1), 0.101);
  EXPECT_GE(firstBound(hull, solid, 0.1), corner);
}

/// Thin plates: what is moved through one is outside again.
TriangleMesh plates(int count, RandomPoints& random) {
  std::vector<TriangleMesh> parts;
  for (int i = 0; i < count; ++i) parts.push_back(test_shapes::moved(test_shapes::box(0.2, 0.2, 0.01), random.inCube()));
  return test_shapes::merged(parts);
}

TEST(SurfaceSearch, TheBoundHoldsWhereverTheFloorIs) {
  RandomPoints random(7);
  int close = 0;
  for (const TriangleMesh& mesh : {test_shapes::openBox(1, 1, 1, 0.1, 3), test_shapes::lBracket(1, 0.2, 1, 3),
                                   test_shapes::torus(0.6, 0.3, 24, 16), test_shapes::sheet(1, 1, 4), plates(12, random)}) {
    const Solid solid = solidOf(mesh);
    for (int trial = 0; trial < 60; ++trial) {
      std::vector<Vector3d> corners;
      for (int i = 0; i < 8; ++i) corners.push_back(random.on(mesh) + random.inCube(0.05));
      const ConvexHull hull = convexHull(corners);
      double most = 0;
      for (const Triangle& t : hull.triangles)
        for (int k = 0; k < 60; ++k) {
          const auto at = [&](std::size_t i) -> const Vector3d& { return hull.vertices[static_cast<std::size_t>(t[i])]; };
          most = std::max(most, solid.distance(random.inTriangle(at(0), at(1), at(2))));
        }
      SurfaceQuery query;
      query.floor = most * random.number(0.5, 1.2);
      query.gap = 1e-3;
      query.halvings = random.index(200);
      const double bound = largestOnSurface(hull, solid, query, {}).bound;
      EXPECT_GE(bound, most);
      close += bound < 1.3 * most;
    }
  }
  EXPECT_GT(close, 60);
}

// The furthest place, in the middle of the mouth, is on the border between triangles, where nothing looks before they are divided.
TEST(SurfaceSearch, WhatIsNotSearchedInTimeKeepsItsBound) {
  const TriangleMesh bowl = test_shapes::openBox(1, 1, 1, 0.05);
  const Solid solid = solidOf(bowl);
  const ConvexHull hull = convexHull(bowl.vertices);
  SurfaceQuery query;
  query.gap = 1e-4;
  const Protrusion exact = largestOnSurface(hull, solid, query, {});
  RunControl late;
  late.deadline = std::chrono::steady_clock::now();
  const Protrusion early = largestOnSurface(hull, solid, query, late);
  EXPECT_LT(early.found, exact.found - 0.01) << "it was searched";
  EXPECT_GE(early.bound, exact.found);
}

}  // namespace
}  // namespace collision_hulls
