// Also tests src/fit/assembly.cpp and src/fit/contacts.cpp.
#include "fit/originals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/contacts.h"
#include "fit/fit_fixtures.h"
#include "fit/fitting.h"
#include "fit/pair_rules.h"

namespace collision_hulls {
namespace {

using namespace fit_fixtures;

TEST(Originals, AMeshIsCheckedAsItsSurface) {
  const FitProblem problem = overPost();
  const Assembly assembly(problem, 1);
  ASSERT_EQ(assembly.parts(), 3u) << "base, carriage, post";
  EXPECT_EQ(assembly.name(1), "c0");
  EXPECT_FALSE(assembly.isLink(2));
  const Originals originals(problem, assembly, {});
  const Places rest = assembly.places(assembly.kinematics().rest());
  EXPECT_FALSE(originals.touch(1, 2, rest)) << "the post stands in the gap";
  const double gap = originals.distanceBelow(1, 1, 2, rest);
  EXPECT_NEAR(gap, 0.04, 1e-6) << "0.15 m to the middle, less 0.05 m of the post and 0.06 m of the wall";
  EXPECT_EQ(originals.distanceBelow(0.02, 1, 2, rest), 0.02);
  EXPECT_TRUE(isClear(originals, CheckedPairs(assembly, {{1, 2, 0.9 * gap}}), rest));
  EXPECT_FALSE(isClear(originals, CheckedPairs(assembly, {{1, 2, 1.1 * gap}}), rest));
}

/// A post 0.25 m beside the channel.
FitProblem besidePost() {
  FitProblem problem = overPost();
  problem.scene.bodies[0].pose.translation().x() += 0.5;
  return problem;
}

TEST(Originals, ADistanceJustBelowTheLimitIsFound) {
  const FitProblem problem = besidePost();
  const Assembly assembly(problem, 1);
  const Originals originals(problem, assembly, {});
  EXPECT_NEAR(originals.distanceBelow(0.251, 1, 2, assembly.places(assembly.kinematics().rest())), 0.25, 1e-6);
}

TEST(Originals, AConfigurationIsClearOnlyWhereEachPairKeepsItsClearance) {
  const FitProblem problem = besidePost();
  const Assembly assembly(problem, 1);
  const Originals originals(problem, assembly, {});
  const Places rest = assembly.places(assembly.kinematics().rest());
  EXPECT_TRUE(isClear(originals, CheckedPairs(assembly, {{1, 2, 0.249}}), rest));
  EXPECT_FALSE(isClear(originals, CheckedPairs(assembly, {{1, 2, 0.251}}), rest));
}

TEST(PairRules, WhatIsProvedOfAPairIsNoMoreThanItsDistance) {
  const FitProblem problem = besidePost();
  const Assembly assembly(problem, 1);
  const PairRules rules = pairRules(problem, assembly, Originals(problem, assembly, {}), 0.01, {});
  ASSERT_EQ(rules.proved.size(), 1u);
  EXPECT_LE(rules.proved[0].bound, 0.25);
  EXPECT_GT(rules.proved[0].bound, 0.24);
}

TEST(PairRules, TheSurveyCountsWhereAPairIsNotClear) {
  FitProblem problem = overPost();
  problem.scene.bodies.push_back(boxBody("chip", {0.01, 0.01, 0.01}, {-0.01, 0.15, 0.5}));  // 5 mm beside the channel's way
  const Assembly assembly(problem, 1);
  const PairRules rules = pairRules(problem, assembly, Originals(problem, assembly, {}), 0.01, {});
  ASSERT_EQ(rules.pairs.size(), 2u) << "with the post, which the channel never touches, and with the chip";
  EXPECT_EQ(rules.pairs[0].unclear, 0u);
  EXPECT_GT(rules.pairs[1].unclear, 50u) << "of 400, where it is within the channel's length of 1 m on a way of 4 m";
  EXPECT_GT(rules.pairs[1].seconds, 0);
}

TEST(PairRules, WhatIsOftenNotClearAndSoonToldIsUrgent) {
  const auto after = [](std::size_t unclear, double seconds) { return urgency({0, 1, 0.01, unclear, seconds}); };
  EXPECT_GT(after(1, 1), after(0, 1));
  EXPECT_GT(after(0, 1), after(0, 2)) << "none of a few hundred is not never";
  EXPECT_TRUE(std::isfinite(after(0, 0)));
}

TEST(Originals, CanBeCancelledWhileFclBuildsItsTrees) {
  const FitProblem problem = overPost();
  const Assembly assembly(problem, 1);
  const RunControl control;
  control.cancel();
  EXPECT_THROW(Originals(problem, assembly, control), Error);
}

TEST(Originals, WhatLiesWithinASolidIsNotClear) {
  FitProblem problem = overPost();
  const Eigen::Vector3d wall(0.03, 0.15, 0.5);  // in the middle of the channel's first wall
  problem.scene.bodies = {boxBody("pin", {0.01, 0.01, 0.01}, wall)};
  const Assembly assembly(problem, 1);
  const Originals originals(problem, assembly, {});
  const Places rest = assembly.places(assembly.kinematics().rest());
  EXPECT_FALSE(originals.touch(1, 2, rest)) << "surfaces are apart";
  EXPECT_EQ(originals.distanceBelow(1, 1, 2, rest), 0);
  EXPECT_FALSE(isClear(originals, CheckedPairs(assembly, {{1, 2, 0.001}}), rest));
  EXPECT_TRUE(originals.contains(1, 2, rest));
  EXPECT_FALSE(originals.contains(2, 1, rest));
  EXPECT_EQ(nesting(assembly, originals, 1, 2, rest), "pin inside c0");
}

TEST(PairRules, BodiesInsideALinkAreNotedAndThoseAroundItTouch) {
  FitProblem problem = overPost();
  problem.robot = carriages(1, 0.1);
  const Eigen::Vector3d wall(0.03, 0.15, 0.5), size(0.01, 0.01, 0.01);
  problem.scene.bodies = {boxBody("pin", size, wall), boxBody("bolt", size, wall), boxBody("room", {5, 5, 5}, gap())};
  const Assembly assembly(problem, 1);
  const Originals originals(problem, assembly, {});
  const Places rest = assembly.places(assembly.kinematics().rest());
  EXPECT_TRUE(originals.touch(1, 4, rest)) << "a convex body is a solid";
  const PairRules rules = pairRules(problem, assembly, originals, 0.01, {});
  EXPECT_EQ(rules.left_out.size(), 3u);
  ASSERT_EQ(rules.notes.size(), 1u) << "one for all that lie inside";
  EXPECT_EQ(rules.notes.back().rfind("pin inside c0, and 1 more pair like it: ", 0), 0u) << rules.notes.back();
}

TEST(Assembly, RootsTouchThePostAndLeavesDoNot) {
  const FitProblem problem = overPost();
  const Assembly assembly(problem, 1);
  const Places rest = assembly.places(assembly.kinematics().rest());
  const CheckedPairs pairs(assembly, {{1, 2, 0.01}});
  EXPECT_TRUE(inContact(assembly, assembly.roots(), pairs, rest));
  EXPECT_EQ(contacts(assembly, assembly.roots(), pairs, rest, 0).size(), 1u);
  Cuts leaves = assembly.roots();
  leaves[0] = problem.elements[0].mesh->tree.cutTo(3);
  EXPECT_FALSE(inContact(assembly, leaves, pairs, rest));
  EXPECT_EQ(assembly.hulls(leaves), 3u);
}

}  // namespace
}  // namespace collision_hulls
