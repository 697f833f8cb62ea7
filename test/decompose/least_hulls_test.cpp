#include "collision_hulls/decompose/least_hulls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "certified/certified_cases.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

std::size_t leastOf(const TriangleMesh& mesh, double tolerance, Effort effort = Effort::kQuick) {
  return leastHulls(mesh, solidOf(mesh), tolerance, {}, effort);
}

/// A base with teeth that stand on it.
TriangleMesh comb(int teeth) {
  std::vector<TriangleMesh> parts{box(teeth - 0.5, 1, 0.5)};
  for (int i = 0; i < teeth; ++i) parts.push_back(moved(box(0.5, 1, 2), {1.0 * i, 0, 0}));
  return merged(parts);
}

/// Three bars through one point.
TriangleMesh cross() {
  return merged({moved(box(4, 1, 1), {-2, -0.5, -0.5}), moved(box(1, 4, 1), {-0.5, -2, -0.5}), moved(box(1, 1, 4), {-0.5, -0.5, -2})});
}

TEST(LeastHulls, OfShapesWhoseNumberIsKnown) {
  EXPECT_EQ(leastOf(box(1, 2, 3), 0.01), 1u);
  EXPECT_EQ(leastOf(sphere(1, 8), 0.01), 1u);
  EXPECT_EQ(leastOf(sheet(), 0.01), 1u);
  EXPECT_EQ(leastOf(singleTriangle(), 0.01), 1u);
  EXPECT_EQ(leastOf(lBracket(), 0.02), 2u);
  EXPECT_EQ(leastOf(uChannel(), 0.02), 3u);
  EXPECT_EQ(leastOf(openBox(), 0.02), 5u);
  EXPECT_EQ(leastOf(cross(), 0.1), 3u);
  EXPECT_EQ(leastOf(fourSpheres(), 0.05), 4u);
  for (const int teeth : {2, 5}) EXPECT_EQ(leastOf(comb(teeth), 0.1), static_cast<std::size_t>(teeth) + 1) << teeth;
  EXPECT_EQ(leastOf(comb(20), 0.1, Effort::kBest), 21u);
}

TEST(LeastHulls, OneWhereTheToleranceAllowsAllInOne) {
  EXPECT_EQ(leastOf(uChannel(), 0.41), 1u);
  EXPECT_EQ(leastOf(comb(5), 0.26), 1u);
}

TEST(LeastHulls, AnInstantGivesNoTimeForABound) {
  EXPECT_EQ(leastOf(openBox(), 0.02, Effort::kInstant), 1u);
}

TEST(LeastHulls, BoxesWithAGapAreTwoOnlyIfItsMiddleIsBeyondTheTolerance) {
  const TriangleMesh boxes = merged({box(1, 1, 1), moved(box(1, 1, 1), {1.2, 0, 0})});
  EXPECT_EQ(leastOf(boxes, 0.0999), 2u);
  EXPECT_EQ(leastOf(boxes, 0.1001), 1u);  // though the gap is wider than the tolerance
}

/// The middle of the gap is further than the tolerance by what coordinates of this size may be rounded by, 1e-12 of them, or by twice that.
TEST(LeastHulls, FarFromTheOriginRoundingCounts) {
  constexpr double kFar = 1e8, kRounding = 1e-4;
  const TriangleMesh boxes = moved(merged({box(1, 1, 1), moved(box(1, 1, 1), {1.25, 0, 0})}), {kFar, 0, 0});
  EXPECT_EQ(leastOf(boxes, 0.125 - 2 * kRounding), 2u);
  EXPECT_EQ(leastOf(boxes, 0.125 - 0.9 * kRounding), 1u);
}

TEST(LeastHulls, ColoursProveMoreThanACliqueForARing) {
  // Points of the inner rim share a hull up to an angle of 2 acos(1 - t / 0.7) = 53.6 degrees, of which 6.7 make a turn.
  EXPECT_EQ(leastOf(torus(1, 0.3, 64, 4), 0.0752, Effort::kBest), 7u);
}

TEST(LeastHulls, NeverMoreThanTheBoxesThatAShapeIsMadeOf) {
  RandomPoints random(3);
  for (int i = 0; i < 40; ++i) {
    const int count = 2 + i % 6;
    std::vector<TriangleMesh> boxes;
    for (int k = 0; k < count; ++k)
      boxes.push_back(moved(box(random.number(0.1, 2), random.number(0.1, 2), random.number(0.1, 2)), random.inCube(1.5)));
    for (const double tolerance : {0.01, 0.1, 0.3})
      EXPECT_LE(leastOf(merged(boxes), tolerance, i % 8 == 0 ? Effort::kBest : Effort::kQuick), static_cast<std::size_t>(count)) << i;
  }
}

/// Hulls that cover a mesh within the tolerance refute any larger bound: it must hold without knowing them, too.
TEST(LeastHulls, NeverMoreThanTheHullsOfACover) {
  const std::vector<TriangleMesh> meshes{torus(),   flange(), flask(), boxWithWindow(), bentTube(),
                                         openBox(), comb(6),  cross(), sheet(1, 1, 4)};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (const double share : {0.05, 0.02, 0.01}) {
      const double tolerance = share * diagonal(meshes[i]);
      const CertifiedHulls cover = certifiedHulls(meshes[i], within(tolerance));
      const std::size_t least = leastOf(meshes[i], tolerance),
                        with_cover = leastHulls(meshes[i], solidOf(meshes[i]), tolerance, cover.hulls);
      EXPECT_GE(std::min(least, with_cover), 1u) << i;
      if (cover.within_tolerance) {
        EXPECT_LE(std::max(least, with_cover), cover.hulls.size()) << i << " " << share;
      }
    }
  }
}

TEST(LeastHulls, OneThreadGivesTheSame) {
  const TriangleMesh mesh = flange();
  const Solid solid = solidOf(mesh);
  std::size_t alone = 0;
  withJobs(1, [&] { alone = leastHulls(mesh, solid, 0.03, {}); });
  EXPECT_GT(alone, 1u);
  EXPECT_EQ(alone, leastHulls(mesh, solid, 0.03, {}));
}

/// They would prove any number.
TEST(LeastHulls, RefusesTolerancesThatAreNone) {
  const TriangleMesh mesh = box(1, 1, 1);
  for (const double tolerance : {-0.5, 0.0, std::nan(""), std::numeric_limits<double>::infinity(), 0.99e-6 * diagonal(mesh)}) {
    try {
      leastOf(mesh, tolerance);
      ADD_FAILURE() << tolerance;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    }
  }
  TriangleMesh wrong = mesh;
  wrong.triangles[0][0] = 99;
  EXPECT_THROW(leastHulls(wrong, solidOf(mesh), 0.1, {}), Error);
}

TEST(LeastHulls, RefusesAMeshWithoutTrianglesAndEndsWhenCancelled) {
  EXPECT_THROW(leastHulls({}, solidOf(box(1, 1, 1)), 0.1, {}), Error);
  RunControl control;
  control.cancel();
  EXPECT_THROW(leastHulls(cross(), solidOf(cross()), 0.1, {}, Effort::kQuick, control), Error);
}

}  // namespace
}  // namespace collision_hulls
