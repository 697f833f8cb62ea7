// How far a surface is from bodies, against closed forms.
#include "verify/cover_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solids.h"
#include "verify/convex_parts.h"
#include "verify/round_shapes.h"
#include "verify_shapes.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;
using namespace test_shapes;

/// A wall of spheres that just covers a square, and one that does not.
TEST(CoverSearch, SpheresThatOverlapEnoughCover) {
  for (const double radius : {0.0708, 0.0700}) {
    LinkBodies bodies;
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j) {
        GeometryElement ball;
        ball.kind = Kind::kSphere;
        ball.size.x() = radius;
        ball.origin = Eigen::Translation3d(0.05 + 0.1 * i, 0.05 + 0.1 * j, 0);
        bodies.primitives.push_back(ball);
      }
    const Largest largest = furthestFrom(BodySet(bodies), test_shapes::sheet(1, 1), 1e-6);
    const double expected = std::max(0.0, 0.05 * std::sqrt(2.0) - radius);  // at the corners of the spheres' squares
    EXPECT_NEAR(largest.found, expected, 1e-5);
    EXPECT_GE(largest.bound, expected);
    EXPECT_LE(largest.bound, 1.011 * expected + 2e-6);
  }
}

TEST(CoverSearch, HullsAndAMeshCoverTogether) {
  LinkBodies bodies;
  bodies.meshes.push_back({lBracket(1, 0.2, 1), convexParts(lBracket(1, 0.2, 1))});
  const TriangleMesh beside = moved(box(0.5, 0.5, 1), {0.2, 0.2, 0});
  bodies.meshes.push_back({beside, convexParts(beside)});
  const BodySet set(bodies);
  ASSERT_TRUE(set.rest());
  ASSERT_EQ(set.hulls().size(), 1u);
  const TriangleMesh across = moved(box(0.6, 0.6, 0.5), {0.05, 0.05, 0.25});  // in both of them
  EXPECT_LT(furthestFrom(set, across, 1e-4).bound, 2e-3);
  const Largest out = furthestFrom(set, moved(across, {0.1, 0, 0}), 1e-4);
  EXPECT_NEAR(out.found, 0.05, 2e-3);
  EXPECT_GE(out.bound, 0.05);
}

TEST(CoverSearch, NoPlaceBetweenSpheresIsFurtherThanTheBound) {
  LinkBodies bodies;
  for (int k = 0; k < 4; ++k) {
    GeometryElement ball;
    ball.kind = Kind::kSphere;
    ball.size.x() = 0.5;
    ball.origin = Eigen::Translation3d(k & 1 ? 1 : 0, k & 2 ? 1 : 0, 0);
    bodies.primitives.push_back(ball);
  }
  const BodySet set(bodies);
  test_shapes::RandomPoints random(9);
  for (int i = 0; i < 10; ++i) {  // sheets about the place in the middle of all four
    const TriangleMesh sheet = moved(test_shapes::sheet(0.6, 0.6), {random.number(0.1, 0.3), random.number(0.1, 0.3), 0});
    EXPECT_GE(furthestFrom(set, sheet, 0.02).bound, std::sqrt(0.5) - 0.5 - 1e-12) << i;
  }
}

TEST(CoverSearch, WhatAMeshLeavesCountsHowFarItsVerticesWereMoved) {
  LinkBodies bodies;
  bodies.meshes.push_back({{}, {}});
  bodies.meshes.back().parts.rest = withLooseTop(lBracket(), kHigher);
  const BodySet set(bodies);
  const Largest largest = furthestFrom(set, moved(test_shapes::sheet(0.02, 0.02), {0.5, 0.04, 1.1}), 1e-9);
  EXPECT_GE(largest.bound, set.whole()->distance(largest.where) + kHigher);
  EXPECT_LE(largest.bound, 0.1 + 2 * kHigher + 1e-6);
  EXPECT_LE(largest.found, 0.1 - kHigher + 1e-9);
}

TEST(CoverSearch, AGapJustAboveRoundingIsFound) {
  LinkBodies bodies;
  bodies.primitives.push_back(boxElement({1, 1, 1}, {0.5, 0.5, 0.5}));
  for (const double gap : {1e-11, 1e-9}) {
    const Largest largest = furthestFrom(BodySet(bodies), moved(test_shapes::sheet(), {0, 0, 1 + gap}), 1e-13);
    EXPECT_GE(largest.bound, 0.999 * gap);
    EXPECT_LE(largest.found, 1.001 * gap);
  }
}

/// A bracket without one of its end faces is no closed surface; its solid's side is then uncertain by its blur.
TEST(CoverSearch, WhatAnOpenMeshLeavesAllowsForItsBlur) {
  TriangleMesh open = lBracket(1, 0.1, 1);
  const auto is_end = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) { return open.vertices[static_cast<std::size_t>(v)].x() == 1; });
  };
  open.triangles.erase(std::remove_if(open.triangles.begin(), open.triangles.end(), is_end), open.triangles.end());
  LinkBodies bodies;
  bodies.meshes.push_back({open, convexParts(open)});
  const BodySet set(bodies);
  ASSERT_TRUE(set.whole() && set.whole()->hasOpenings());
  const Largest largest = furthestFrom(set, moved(test_shapes::sheet(0.02, 0.02), {0.5, 0.04, 1.1}), 1e-12);
  EXPECT_NEAR(largest.found, 0.1, 1e-12);
  EXPECT_GE(largest.bound, largest.found + set.whole()->sideError());
}

/// The polyhedron in a ball is further away than the ball.
TEST(CoverSearch, WhatIsFoundBesideABallIsNoFurtherThanFromTheBall) {
  test_shapes::RandomPoints random(12);
  for (int i = 0; i < 12; ++i) {
    LinkBodies bodies;
    bodies.primitives.push_back(roundElement(Kind::kSphere, 0.2));
    const TriangleMesh aside = moved(lBracket(), {5, 5, 5});
    bodies.meshes.push_back({aside, convexParts(aside)});
    const Eigen::Vector3d place = bodies.primitives[0].origin * (0.3 * random.onSphere());
    const Largest largest = furthestFrom(BodySet(bodies), moved(test_shapes::sheet(1e-9, 1e-9), place), 1e-9);
    EXPECT_LE(largest.found, 0.1 + 1e-8) << i;
    EXPECT_GE(largest.bound, 0.1 - 1e-8) << i;
  }
}

TEST(CoverSearch, TheBoundAllowsForTheRoundingOfCoordinates) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const FarAway far(seed);
    ASSERT_EQ(far.side.size(), 2u);
    LinkBodies bodies;
    bodies.meshes.push_back({{}, {}});
    bodies.meshes.back().parts.rest = far.bracket;
    EXPECT_GE(static_cast<Exact>(furthestFrom(BodySet(bodies), far.speck, 1e-9).bound), far.distance()) << seed;
  }
}

}  // namespace
}  // namespace collision_hulls
