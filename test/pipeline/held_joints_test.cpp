// Fits in which only some joints move. Tests src/pipeline/scene/held_joints.cpp.
#include "pipeline/scene/held_joints.h"

#include "collision_hulls/robot/kinematics.h"
#include "pipeline/scene_run.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

using fixtures::FitRobotToScene;
using Held = std::map<std::string, double>;

std::string joint(const std::string& name, const std::string& type, const std::string& more) {
  return "<link name='" + name + "_link'/><joint name='" + name + "' type='" + type + "'><parent link='base'/><child link='" + name +
         "_link'/>" + more + "</joint>";
}

std::string limit(const std::string& lower, const std::string& upper) {
  return "<limit lower='" + lower + "' upper='" + upper + "' effort='1' velocity='1'/>";
}

/// A lift whose range begins above zero, two joints of an arm, a finger that mimics one, and a joint without room.
RobotDescription robot() {
  return parseRobotDescription("<robot name='r'><link name='base'/>" + joint("lift", "prismatic", limit("0.1", "0.5")) +
                               joint("arm_pan", "continuous", "") + joint("arm_tilt", "revolute", limit("-1", "1")) +
                               joint("finger", "revolute", "<mimic joint='arm_tilt'/>" + limit("-1", "1")) +
                               joint("stuck", "revolute", limit("0.2", "0.2")) + "</robot>");
}

TEST(HeldJoints, AreThoseThatTheExpressionDoesNotMatchAtRestAndThoseWithAPosition) {
  EXPECT_EQ(heldJoints(Kinematics(robot()), "", {}), Held());
  EXPECT_EQ(heldJoints(Kinematics(robot()), "arm_.*", {}), (Held{{"lift", 0.1}})) << "of rest, the limit nearest to zero";
}

TEST(HeldJoints, HaveTheirPositions) {
  EXPECT_EQ(heldJoints(Kinematics(robot()), "arm_.*", {{"lift", 0.4}}), (Held{{"lift", 0.4}}));
  EXPECT_EQ(heldJoints(Kinematics(robot()), "", {{"arm_pan", 3}}), (Held{{"arm_pan", 3}})) << "all others move";
  EXPECT_EQ(heldJoints(Kinematics(robot()), "arm_.*", {{"arm_pan", 0.5}}), (Held{{"arm_pan", 0.5}, {"lift", 0.1}}));
}

TEST(HeldJoints, ErrorsNameWhatIsWrong) {
  const auto expectBad = [](const std::vector<std::string>& parts, const std::string& moving, const Held& at) {
    expectError(ErrorCode::kBadOption, parts, [&] { heldJoints(Kinematics(robot()), moving, at); });
  };
  expectBad({"joints 'wrist' matches no joint with room between its limits; those with room are arm_pan, arm_tilt, lift"}, "wrist", {});
  expectBad({"joints 'stuck' matches no joint with room"}, "stuck", {});
  expectBad({"joints", "(arm"}, "(arm", {});
  expectBad({"joint 'elbow' cannot be set", "those that can be set are "}, "", {{"elbow", 1}});
  expectBad({"joint 'finger' cannot be set"}, "", {{"finger", 1}});
  expectBad({"joint 'lift' at 0.900000 is beyond its limits"}, "", {{"lift", 0.9}});
  expectBad({"at holds each joint that could move"}, "arm_pan", {{"arm_pan", 1}});
}

TEST(HeldJoints, StayWhereTheyAreInEveryConfiguration) {
  const Kinematics kinematics(withJointsHeld(robot(), {{"lift", 0.4}, {"arm_pan", 3}}));
  ASSERT_EQ(kinematics.variables().size(), 4u);
  EXPECT_FALSE(kinematics.variables()[0].continuous) << "what mimics it is settled";
  for (const double share : {0.0, 0.5, 1.0}) {
    const Configuration configuration = kinematics.sample([&] { return share; });
    EXPECT_EQ(configuration[0], 3);
    EXPECT_NEAR(configuration[1], 2 * share - 1, 1e-12);
    EXPECT_EQ(configuration[2], 0.4);
  }
  EXPECT_EQ(kinematics.rest(), (Configuration{3, 0, 0.4, 0.2}));
}

/// Two boxes of 2 cm that slide along x, 2 m from each other.
std::string twoBoxes(const std::string& box) {
  const auto sliding = [&](const std::string& name, const std::string& y) {
    return fixtures::link(name, box) + "<joint name='to_" + name + "' type='prismatic'><parent link='base'/><child link='" + name +
           "'/><origin xyz='0 " + y + " 0'/><axis xyz='1 0 0'/>" + limit("0", "0.4") + "</joint>";
  };
  return fixtures::link("base", "") + sliding("left", "1") + sliding("right", "-1");
}

TEST_F(FitRobotToScene, LearnsOfOneArmWhileTheOtherIsHeld) {
  fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.02, 0.02, 0.02)));
  const std::string robot = twoBoxes(collision(fixtures::meshTag("../meshes/box.obj")));
  request_.scene.bodies = {{"wall", boxShape({0.32, 0.5, 0.5}), at(0.26, 1, 0)}, {"post", boxShape({0.1, 0.1, 0.1}), at(0.3, -1, 0)}};
  const RobotResult all = run(robot);
  EXPECT_LT(all.report.scene->clear, 25u) << "the left one is mostly in the wall";
  EXPECT_EQ(all.report.scene->held, Held());
  request_.joints = "to_right";
  const RobotResult one = run(robot);
  EXPECT_EQ(one.report.scene->held, (Held{{"to_left", 0}}));
  EXPECT_GT(one.report.scene->clear, 50u) << "all but those in the post";
  EXPECT_NE(toTable(one.report).find("100 random configurations with 1 joint held: "), std::string::npos) << toTable(one.report);
  EXPECT_NE(toJson(one.report).find("\"to_left\": 0"), std::string::npos);
  const auto never = [](const RobotResult& result) { return result.extra_files.at("config/arm_disabled.srdf").find("Never"); };
  EXPECT_NE(never(all), std::string::npos) << "2 m apart, whatever the joints do";
  EXPECT_EQ(never(one), std::string::npos) << "what is held here may move elsewhere";
  request_.at = {{"to_left", 0.2}};
  EXPECT_EQ(run(robot).report.scene->left_out.size(), 1u) << "held in the wall";
  request_.configurations = {{0, 0}};
  expectError(ErrorCode::kBadOption, {"so joint 'to_left' cannot be held; omit joints 'to_right' and at, or the configurations"},
              [&] { run(robot); });
}

TEST_F(FitRobotToScene, DisablesWhatTouchesAtRestWhereverJointsAreHeld) {
  fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.02, 0.02, 0.02)));
  const std::string box = collision(fixtures::meshTag("../meshes/box.obj"));
  const auto sliding = [&](const std::string& name, const std::string& from) {
    return fixtures::link(name, box) + "<joint name='to_" + name + "' type='prismatic'><parent link='base'/><child link='" + name +
           "'/><origin xyz='" + from + " 0 0'/><axis xyz='1 0 0'/>" + limit("0", "0.4") + "</joint>";
  };
  // At rest the first two touch; the third stands alone.
  const std::string robot = fixtures::link("base", "") + sliding("one", "0") + sliding("two", "0.01") + sliding("three", "0.5");
  request_.scene.bodies = {};
  const auto pair = [](const std::string& a, const std::string& b, const std::string& reason) {
    return "link1=\"" + a + "\" link2=\"" + b + "\" reason=\"" + reason + "\"";
  };
  const auto srdf = [](const RobotResult& result) { return result.extra_files.at("config/arm_disabled.srdf"); };
  request_.joints = "to_three";
  EXPECT_NE(srdf(run(robot)).find(pair("one", "two", "Default")), std::string::npos) << "as without joints that are held";
  request_.joints = "to_one";
  request_.at = {{"to_two", 0.4}, {"to_three", 0}};  // two then stands at 0.41, before three
  const RobotResult apart = run(robot);
  EXPECT_NE(srdf(apart).find(pair("one", "two", "Default")), std::string::npos) << "at rest they touch";
  request_.at = {{"to_two", 0.4}, {"to_three", 0.0}};
  request_.joints = "to_one";
  const std::string near = fixtures::link("base", "") + sliding("one", "0") + sliding("two", "0.2") + sliding("three", "0.6");
  const RobotResult held = run(near);  // two then stands in three, and does not at rest
  EXPECT_EQ(srdf(held).find(pair("two", "three", "Default")), std::string::npos) << srdf(held);
  EXPECT_EQ(srdf(held).find(pair("two", "three", "Always")), std::string::npos) << srdf(held);
  EXPECT_TRUE(isNoted(held,
                      "1 pair of links is left out (two and three): the original meshes touch there in nearly all configurations with the "
                      "joints held, though not at rest"))
      << fixtures::joined(held.report.notes);
}

TEST(JointPositions, AreJointsWithValues) {
  EXPECT_EQ(jointPositions({"a=1", "b=-0.5", "c=d=2"}, "--at"), (Held{{"a", 1}, {"b", -0.5}, {"c=d", 2}}));
  for (const char* const text : {"a", "=1", "a=", "a=one", "a=inf", "a=1rad"})
    expectError(ErrorCode::kBadOption, {"--at '" + std::string(text) + "' is invalid"}, [&] { jointPositions({text}, "--at"); });
  expectError(ErrorCode::kBadOption, {"--at 'a=2': joint 'a' has a position already"}, [&] { jointPositions({"a=1", "a=2"}, "--at"); });
}

}  // namespace
}  // namespace collision_hulls
