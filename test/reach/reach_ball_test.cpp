#include "reach/reach_ball.h"

#include "geometry/random_stream.h"
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

TEST(ReachBall, AFixedLinkStaysWhereItIs) {
  Chain chain;
  chain.end.translation() = Eigen::Vector3d(1, 2, 3);
  const ReachBall ball = reachBall(chain, {}, 0.5);
  EXPECT_EQ(ball.centre, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(ball.radius, 0.5);
}

/// A lift on a turntable that is 1 m off the root, an arm on it, and a finger that slides against it at twice the lift's pace.
RobotDescription liftWithArm() {
  const auto joint = [](const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                        const std::string& rest) {
    return "<link name='" + child + "'/><joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" +
           child + "'/>" + rest + "</joint>";
  };
  const std::string limits = "<limit lower='-0.2' upper='0.7' effort='1' velocity='1'/>";
  return parseRobotDescription(
      "<robot name='r'><link name='root'/>" + joint("turn", "continuous", "root", "table", "<origin xyz='1 0 0'/><axis xyz='0 0 1'/>") +
      joint("lift", "prismatic", "table", "carriage", "<origin xyz='0.3 0 0'/><axis xyz='0 0 1'/>" + limits) +
      joint("swing", "continuous", "carriage", "arm", "<origin xyz='0 0.1 0.2'/><axis xyz='1 0 0'/>") +
      joint("slide", "prismatic", "arm", "finger",
            "<origin xyz='0 0 0.4'/><axis xyz='0 1 0'/><mimic joint='lift' multiplier='-2' offset='0.1'/>" + limits) +
      "</robot>");
}

TEST(ReachBall, HoldsTheLinkInEveryConfiguration) {
  const Kinematics kinematics(liftWithArm());
  constexpr double kRadius = 0.25;
  const Eigen::Vector3d point(0, 0.15, 0.2);  // of each link, kRadius from its origin
  Random random(1, 0, 0);
  for (std::size_t link = 0; link < kinematics.links(); ++link) {
    const ReachBall ball = reachBall(kinematics.chain(link), kinematics.variables(), kRadius);
    double furthest = 0;
    for (int i = 0; i < 2000; ++i) {
      Configuration configuration;
      for (const JointVariable& variable : kinematics.variables()) configuration.push_back(random.uniform(variable.lower, variable.upper));
      furthest = std::max(furthest, (kinematics.poses(configuration)[link] * point - ball.centre).norm());
    }
    EXPECT_LE(furthest, ball.radius + 1e-12) << link;
    EXPECT_GT(furthest, 0.3 * ball.radius) << link << ": much larger than need be";
  }
}

TEST(ReachBall, AddsUpLengths) {
  const Kinematics kinematics(liftWithArm());
  const ReachBall finger = reachBall(kinematics.chain(4), kinematics.variables(), 0.25);
  EXPECT_EQ(finger.centre, Eigen::Vector3d(1, 0, 0)) << "the turntable's axis";
  EXPECT_NEAR(finger.radius, 0.3 + 0.7 + std::hypot(0.1, 0.2) + 0.4 + (2 * 0.7 - 0.1) + 0.25, 1e-12);
}

}  // namespace
}  // namespace collision_hulls
