// Also tests src/decompose/least/pairs.cpp.
#include "decompose/least/sharing.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

constexpr Sharing::Limits kLimits{1'000, 1'000};

/// Small balls on a circle of radius 1, as points in their middles would be: so far apart that none of a hull's points may lie between.
struct Beads {
  explicit Beads(int count) {
    std::vector<TriangleMesh> balls;
    for (int i = 0; i < count; ++i) {
      points.emplace_back(std::cos(2 * kPi * i / count), std::sin(2 * kPi * i / count), 0);
      balls.push_back(moved(sphere(0.05, 2), points.back()));
    }
    mesh = merged(balls);
  }

  /// Whether all points are proved to need more sets.
  bool needMoreThan(std::size_t sets, double tolerance, const Sharing::Limits& limits = kLimits) const {
    const Solid solid = solidOf(mesh);
    const Apart apart(solid, tolerance, 2);
    const PairTest pairs(points, {}, apart);
    Sharing sharing(points, pairs, apart, limits);
    for (std::size_t i = 0; i < points.size(); ++i) sharing.add(i);
    return sharing.needsMoreThan(sets);
  }

  Points points;
  TriangleMesh mesh;
};

TEST(Sharing, AsManySetsAsPointsThatAreAllApart) {
  const Beads beads(5);
  EXPECT_FALSE(beads.needMoreThan(5, 0.1));
  EXPECT_TRUE(beads.needMoreThan(4, 0.1));
}

TEST(Sharing, TriplesMatterWherePairsAreNotApart) {  // sides are 0.87 from the middle of the circle, balls 0.95
  const Beads beads(6);
  EXPECT_TRUE(beads.needMoreThan(1, 0.93));
  EXPECT_TRUE(beads.needMoreThan(1, 0.93, {0, 1'000}));  // opposite ones are a pair
  const Beads three(3);                                  // the middle of a side is 0.87 from the balls' middles, the middle of all is 1
  EXPECT_TRUE(three.needMoreThan(1, 0.9));
  EXPECT_FALSE(three.needMoreThan(1, 0.9, {0, 1'000}));  // none tested
  EXPECT_FALSE(three.needMoreThan(2, 0.9));
  EXPECT_FALSE(three.needMoreThan(1, 1));
}

TEST(Sharing, ProvesNothingWithoutSteps) {
  EXPECT_FALSE(Beads(7).needMoreThan(6, 0.1, {1'000, 5}));
}

/// Whether the points from `next` on can be added to the sets without any that are apart; tries every assignment.
bool canShareByTrial(const Points& points, const Apart& apart, std::vector<std::vector<std::size_t>>& sets, std::size_t next) {
  if (next == points.size()) return true;
  for (std::vector<std::size_t>& set : sets) {
    bool fits = true;
    for (const std::size_t a : set) {
      fits = fits && !apart(points[next], points[a]);
      for (const std::size_t b : set) fits = fits && (b >= a || !apart(points[next], points[a], points[b]));
    }
    if (!fits) continue;
    set.push_back(next);
    if (canShareByTrial(points, apart, sets, next + 1)) return true;
    set.pop_back();
  }
  return false;
}

TEST(Sharing, AgreesWithATrialOfAllAssignments) {
  int yes = 0, no = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    RandomPoints random(seed);
    Points points;
    std::vector<TriangleMesh> balls;
    for (int i = 0; i < 9; ++i) {
      points.push_back(random.inCube());
      balls.push_back(moved(sphere(0.05, 2), points.back()));
    }
    const Solid solid = solidOf(merged(balls));
    const Apart apart(solid, random.number(0.3, 0.6), 2);
    const PairTest pairs(points, {}, apart);
    for (std::size_t sets = 2; sets < 5; ++sets) {
      Sharing sharing(points, pairs, apart, {100'000, 100'000});
      for (std::size_t i = 0; i < points.size(); ++i) sharing.add(i);
      std::vector<std::vector<std::size_t>> trial(sets);
      const bool can = canShareByTrial(points, apart, trial, 0);
      EXPECT_EQ(sharing.needsMoreThan(sets), !can) << seed << " " << sets;
      ++(can ? yes : no);
    }
  }
  EXPECT_GT(yes, 10);
  EXPECT_GT(no, 10);
}

TEST(Sharing, ThePointThatMostSetsRefuseComesNext) {
  const Beads beads(6);
  const Solid solid = solidOf(beads.mesh);
  const Apart apart(solid, 0.5, 2);  // neighbours are not apart
  const PairTest pairs(beads.points, {}, apart);
  Sharing sharing(beads.points, pairs, apart, kLimits);
  sharing.add(0);
  sharing.add(2);
  ASSERT_FALSE(sharing.needsMoreThan(2));
  EXPECT_EQ(sharing.mostRefused(), 4u);
}

TEST(PairTest, PointsInAKnownHullNeedNoTest) {
  const Beads beads(4);
  const Solid solid = solidOf(beads.mesh);
  const Apart apart(solid, 0.1, 2);
  const std::vector<ConvexHull> known{boxHull({-2, -2, -1}, {2, 2, 1})};
  EXPECT_TRUE(PairTest(beads.points, {}, apart)(0, 1));
  EXPECT_FALSE(PairTest(beads.points, known, apart)(0, 1));
  EXPECT_FALSE(PairTest(beads.points, {}, apart)(1, 1));
  PairTest tested(beads.points, {}, apart);
  EXPECT_TRUE(tested.graphOf(3, {}).connected(2, 0));
  EXPECT_TRUE(tested(2, 0) && tested(3, 0));
}

}  // namespace
}  // namespace collision_hulls
