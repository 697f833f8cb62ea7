#include "planning/joint_space.h"

#include <gtest/gtest.h>

#include "plan_fixtures.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

struct Arm {
  RobotDescription robot = parseRobotDescription(plan_fixtures::arm());
  Kinematics kinematics{robot};

  std::size_t link(const std::string& name) const {
    for (std::size_t i = 0; i < robot.links.size(); ++i)
      if (robot.links[i].name == name) return i;
    ADD_FAILURE() << name;
    return 0;
  }
};

std::vector<std::string> names(const JointSpace& space) {
  std::vector<std::string> result;
  for (const JointVariable& joint : space.joints()) result.push_back(joint.name);
  return result;
}

TEST(JointSpace, TakesAllJointsThatMoveOrThoseNamed) {
  const Arm arm;
  EXPECT_EQ(names({arm.kinematics, ""}).size(), 3u) << "the mimic joint is no variable";
  EXPECT_EQ(names({arm.kinematics, "li.*"}), std::vector<std::string>{"lift"});
  expectError(ErrorCode::kBadOption, {"'tur'", "turn", "lift", "spin"}, [&] { JointSpace(arm.kinematics, "tur"); });
  expectError(ErrorCode::kBadOption, {"joints", "("}, [&] { JointSpace(arm.kinematics, "("); });
}

TEST(JointSpace, OtherJointsStayWhereTheyArePut) {
  const Arm arm;
  const JointSpace space(arm.kinematics, "lift", {{"turn", 0.5}});
  const Configuration all = space.configuration({0.1});
  EXPECT_EQ(all, arm.kinematics.configuration({{"turn", 0.5}, {"lift", 0.1}}));
  EXPECT_EQ(space.values(all), JointValues{0.1});
  EXPECT_NEAR(space.poses({0.1})[arm.link("hook")].translation().z(), 0.2, 1e-12) << "the mimic joint follows";
  expectError(ErrorCode::kBadOption, {"turn"}, [&] { JointSpace(arm.kinematics, "lift", {{"turn", 4}}); });
  EXPECT_EQ(names({arm.kinematics, "", {{"turn", 0.5}}}), (std::vector<std::string>{"spin", "lift"})) << "as in a fit";
  expectError(ErrorCode::kBadOption, {"at", "leave one"}, [&] { JointSpace(arm.kinematics, "turn", {{"turn", 0.5}}); });
}

TEST(JointSpace, KnowsWhatThePlannedJointsMove) {
  const Arm arm;
  const JointSpace turn(arm.kinematics, "turn"), lift(arm.kinematics, "lift");
  EXPECT_TRUE(turn.moves(arm.link("cap")));
  EXPECT_FALSE(turn.moves(arm.link("mast")));
  EXPECT_FALSE(turn.moves(arm.link("cap"), arm.link("rod"))) << "both go along";
  EXPECT_TRUE(turn.moves(arm.link("cap"), arm.link("base")));
  EXPECT_FALSE(lift.moves(arm.link("rod")));
  EXPECT_TRUE(lift.moves(arm.link("cap"), arm.link("rod")));
  EXPECT_TRUE(lift.moves(arm.link("cap"), arm.link("hook"))) << "one variable, two joints, at different paces";
}

TEST(JointSpace, ContinuousJointsTakeTheShorterWay) {
  const Arm arm;
  const JointSpace space(arm.kinematics, "turn|spin");
  ASSERT_EQ(names(space), (std::vector<std::string>{"spin", "turn"}));
  const JointValues middle = between(space.joints(), {-3, -3}, {3, 3}, 0.5);
  EXPECT_NEAR(std::abs(middle[0]), test_shapes::kPi, 1e-12);
  EXPECT_NEAR(middle[1], 0, 1e-12);
}

TEST(JointSpace, StepsAlongAPathAreNoLongerThanTheirShareOfTheRange) {
  const Arm arm;
  const JointSpace space(arm.kinematics, "turn|lift");  // ranges of 6 rad and 0.2 m
  const std::vector<JointValues> along = alongPath(space.joints(), {{0, 0}, {1.2, 0}, {1.2, 0.2}}, 0.1);
  ASSERT_EQ(along.size(), 2u + 10 + 1) << "1.2 rad are two tenths of the range, 0.2 m are ten";
  EXPECT_EQ(along.front(), (JointValues{0, 0}));
  EXPECT_NEAR(along[1][0], 0.6, 1e-12);
  EXPECT_NEAR(along[3][1], 0.02, 1e-12);
  EXPECT_EQ(along.back(), (JointValues{1.2, 0.2}));
  EXPECT_TRUE(alongPath(space.joints(), {}, 0.1).empty());
}

}  // namespace
}  // namespace collision_hulls
