#include "decompose/certified/hull_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/decompose/hull_tree.h"
#include "decompose/certified/certified_cases.h"

namespace collision_hulls {
namespace {

using test_shapes::expectCovers;
using test_shapes::kGap;

/// A curve whose hulls number kLength over the tolerance, each of which protrudes by `share` of it.
struct Curve {
  static constexpr double kLength = 100;
  double share = 1;
  std::vector<double> asked;

  BoundedHulls at(double tolerance) {
    asked.push_back(tolerance);
    return {std::vector<ConvexHull>(static_cast<std::size_t>(std::ceil(kLength / tolerance))), share * tolerance};
  }
  BoundedHulls within(std::size_t limit, double most, BoundedHulls best = {}) {
    return withinLimit(1, 100, limit, most, std::move(best), [this](double tolerance) { return at(tolerance); });
  }
};

TEST(HullLimit, IsKeptAtNearlyTheLeastTolerance) {
  for (const std::size_t limit : {2u, 3u, 7u, 16u, 33u, 64u, 99u}) {
    Curve curve;
    const BoundedHulls few = curve.within(limit, 1000);
    const double least = Curve::kLength / static_cast<double>(limit);
    EXPECT_LE(few.hulls.size(), limit);
    EXPECT_GE(few.bound, least * (1 - 1e-9));
    EXPECT_LE(few.bound, least * 1.0501) << limit;
    EXPECT_LE(curve.asked.size(), 11u) << limit;
  }
}

// Hulls that protrude less than they may show that a smaller tolerance would have done.
TEST(HullLimit, NothingIsTriedAboveABoundThatWasReached) {
  Curve curve;
  curve.share = 0.5;
  curve.within(40, 1000);
  ASSERT_GT(curve.asked.size(), 2u);
  const auto few = std::find_if(curve.asked.begin(), curve.asked.end(), [](double tried) { return tried >= Curve::kLength / 40; });
  for (auto later = few + 1; later < curve.asked.end(); ++later) EXPECT_LE(*later, curve.share * *few);
}

TEST(HullLimit, WhatIsKnownIsKeptUnlessLessProtrudes) {
  Curve curve;
  const BoundedHulls better = curve.within(10, 1000, {std::vector<ConvexHull>(9), 2});
  EXPECT_EQ(better.hulls.size(), 9u);
  EXPECT_EQ(better.bound, 2);
  for (const double tried : curve.asked) EXPECT_LT(tried, 2);
  const BoundedHulls worse = curve.within(10, 1000, {std::vector<ConvexHull>(9), 20});
  EXPECT_EQ(worse.hulls.size(), 10u);
  EXPECT_LT(worse.bound, 12);
}

TEST(HullLimit, LaterHullsThatProtrudeFurtherAreNotTaken) {
  std::vector<double> asked;
  const BoundedHulls few = withinLimit(1, 100, 10, 1000, {}, [&](double tolerance) {
    asked.push_back(tolerance);
    return BoundedHulls{std::vector<ConvexHull>(5), 10 / tolerance};  // as where time ends
  });
  EXPECT_GT(asked.size(), 1u);
  EXPECT_EQ(few.bound, 10 / asked.front());
}

TEST(HullLimit, OneHullIsAskedForOnce) {
  Curve curve;
  EXPECT_EQ(curve.within(1, 200).hulls.size(), 1u);
  EXPECT_EQ(curve.asked, std::vector<double>{200});
}

TEST(HullLimit, NothingFoundIsNothing) {
  const auto many = [](double) { return BoundedHulls{std::vector<ConvexHull>(50), 1}; };
  EXPECT_TRUE(withinLimit(1, 60, 10, 1000, {}, many).hulls.empty());
}

double boundOf(const std::vector<ConvexHull>& hulls, const RepairedMesh& mesh, double gap) {
  return protrusion(expectCovers(mesh, hulls, 0).hulls, Solid(mesh), gap).bound;
}

TEST(HullLimit, HullsProtrudeNoFurtherThanThoseOfTheTreeAndMuchLessInSum) {
  double limited = 0, of_tree = 0;
  for (const TriangleMesh& mesh : {test_shapes::torus(1, 0.3, 32, 16), test_shapes::bentTube(), test_shapes::flange()}) {
    const RepairedMesh repaired = repair(mesh);
    DecomposeOptions options = test_shapes::within(0.02 * diagonal(mesh));
    const HullTree tree = hullTree(repaired, options);
    for (const int limit : {3, 6}) {
      options.max_hulls = limit;
      const Decomposition few = certified(repaired, options);
      ASSERT_TRUE(few.capped);
      EXPECT_LE(few.hulls.size(), static_cast<std::size_t>(limit));
      const double gap = kGap * options.tolerance, bound = boundOf(few.hulls, repaired, gap);
      const double before = boundOf(tree.hullsOf(tree.cutTo(limit)), repaired, gap);
      EXPECT_LE(bound, 1.05 * before);
      limited += bound;
      of_tree += before;
    }
  }
  EXPECT_LT(limited, 0.9 * of_tree);
}

TEST(HullLimit, OneHullIsThatOfTheMesh) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 32, 16);
  DecomposeOptions options = test_shapes::within(0.01, Effort::kQuick, 0);
  options.max_hulls = 1;
  const Decomposition one = certified(repair(mesh), options);
  ASSERT_EQ(one.hulls.size(), 1u);
  EXPECT_NEAR(volume(one.hulls.front()), volume(convexHull(mesh.vertices)), 1e-6);
}

}  // namespace
}  // namespace collision_hulls
