#include "measure/surface_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;
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
