#include "planning/planner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan_fixtures.h"
#include "planning/plan_queries.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

const std::vector<JointVariable> kPlane{{"x", -1, 1, false}, {"y", -1, 1, false}};

/// A wall at x = 0 with a door above y = 0.5.
bool throughTheDoor(const JointValues& p) {
  return std::abs(p[0]) > 0.1 || p[1] > 0.5;
}

PlannerSettings settings(std::uint32_t seed) {
  PlannerSettings result;
  result.seed = seed;
  result.time_limit = 60;
  return result;
}

TEST(Planner, FindsAWayThatIsFree) {
  const Plan found = plan(kPlane, {-0.8, 0}, {0.8, 0}, throughTheDoor, settings(1));
  ASSERT_EQ(found.outcome, Plan::Outcome::kSolved);
  EXPECT_EQ(found.path.front(), (JointValues{-0.8, 0}));
  EXPECT_EQ(found.path.back(), (JointValues{0.8, 0}));
  EXPECT_EQ(hits(alongPath(kPlane, found.path, 0.005), throughTheDoor), 0u);
  for (const JointValues& state : alongPath(kPlane, found.path, 0.005))
    for (const double value : state) EXPECT_LE(std::abs(value), 1);
}

TEST(Planner, TheSameSeedGivesTheSamePath) {
  const auto path = [](std::uint32_t seed) { return plan(kPlane, {-0.8, 0}, {0.8, 0}, throughTheDoor, settings(seed)).path; };
  const auto first = path(7);
  EXPECT_NE(path(8), first);
  EXPECT_EQ(path(7), first);
}

TEST(Planner, ALostStartOrGoalIsSaidAtOnce) {
  for (const auto& [start, goal] : {std::pair(JointValues{0, 0}, JointValues{0.8, 0}), std::pair(JointValues{0.8, 0}, JointValues{0, 0})}) {
    const Plan found = plan(kPlane, start, goal, throughTheDoor, settings(1));
    EXPECT_EQ(found.outcome, Plan::Outcome::kLost);
    EXPECT_TRUE(found.path.empty());
  }
}

TEST(Planner, GivesUpWhenTimeIsOut) {
  PlannerSettings short_of_time = settings(1);
  short_of_time.time_limit = 0.01;
  const auto walled = [](const JointValues& p) { return std::abs(p[0]) > 0.1; };
  EXPECT_EQ(plan(kPlane, {-0.8, 0}, {0.8, 0}, walled, short_of_time).outcome, Plan::Outcome::kTimeout);
  EXPECT_STREQ(name(Plan::Outcome::kTimeout), "timeout");
}

TEST(Planner, AContinuousJointTurnsThroughPi) {
  const std::vector<JointVariable> wheel{{"spin", -test_shapes::kPi, test_shapes::kPi, true}};
  const auto not_at_zero = [](const JointValues& p) { return std::abs(p[0]) > 0.5; };
  const Plan found = plan(wheel, {-1}, {1}, not_at_zero, settings(1));
  ASSERT_EQ(found.outcome, Plan::Outcome::kSolved);
  EXPECT_EQ(hits(alongPath(wheel, found.path, 0.005), not_at_zero), 0u);
}

struct Turning {
  RobotDescription robot = parseRobotDescription(plan_fixtures::arm());
  Kinematics kinematics{robot};
  JointSpace space{kinematics, "turn"};
};

TEST(PlanQueries, AreFreeAndNotStraightAndRepeatable) {
  const Turning arm;
  const IsFree is_free = [](const JointValues& p) { return std::abs(p[0]) > 0.3; };
  const auto queries = drawQueries(arm.kinematics, arm.space, is_free, 0.01, 20, 1);
  for (const PlanQuery& query : queries) {
    EXPECT_TRUE(is_free(query.start) && is_free(query.goal));
    EXPECT_LT(query.start[0] * query.goal[0], 0) << "on either side of what is in the way";
  }
  const auto values = [&](std::uint64_t seed, std::size_t count) {
    std::vector<JointValues> all;
    for (const PlanQuery& query : drawQueries(arm.kinematics, arm.space, is_free, 0.01, count, seed)) {
      all.push_back(query.start);
      all.push_back(query.goal);
    }
    return all;
  };
  const std::vector<JointValues> twenty = values(1, 20), five = values(1, 5);
  EXPECT_EQ(five, std::vector<JointValues>(twenty.begin(), twenty.begin() + 10));
  EXPECT_EQ(values(1, 20), twenty);
  EXPECT_NE(values(2, 20), twenty);
}

TEST(PlanQueries, SayWhyThereAreNone) {
  const Turning arm;
  expectError(ErrorCode::kBadOption, {"no free state", "--at"}, [&] {
    drawQueries(
        arm.kinematics, arm.space, [](const JointValues&) { return false; }, 0.01, 1, 1);
  });
  expectError(ErrorCode::kBadOption, {"straight", "--joints"}, [&] {
    drawQueries(
        arm.kinematics, arm.space, [](const JointValues&) { return true; }, 0.5, 1, 1);
  });
}

}  // namespace
}  // namespace collision_hulls
