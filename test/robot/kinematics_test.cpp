#include "collision_hulls/robot/kinematics.h"

#include <cmath>
#include <limits>
#include <random>

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::string links(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "<link name=\"l" + std::to_string(i) + "\"/>";
  return text;
}

/// From link l<i> to l<i + 1>, one metre along x, turning about z or sliding along it.
std::string joint(int i, const std::string& type, const std::string& more = "") {
  const std::string n = std::to_string(i);
  return "<joint name=\"j" + n + "\" type=\"" + type + "\"><parent link=\"l" + n + "\"/><child link=\"l" + std::to_string(i + 1) +
         "\"/><origin xyz=\"1 0 0\"/><axis xyz=\"0 0 2\"/>" + more + "</joint>";
}

std::string limit(double lower, double upper) {
  return "<limit lower=\"" + std::to_string(lower) + "\" upper=\"" + std::to_string(upper) + "\" effort=\"1\" velocity=\"1\"/>";
}

RobotDescription robot(const std::string& content) {
  return parseRobotDescription("<robot name=\"r\">" + content + "</robot>");
}

TEST(Kinematics, OneLink) {
  const Kinematics kinematics(robot(links(1)));
  EXPECT_TRUE(kinematics.variables().empty());
  ASSERT_EQ(kinematics.poses({}).size(), 1u);
  EXPECT_TRUE(kinematics.poses({})[0].isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(kinematics.adjacent(0, 0));
}

TEST(Kinematics, EachKindOfJoint) {
  const Kinematics kinematics(robot(links(6) + joint(0, "revolute", limit(-1, 2)) + joint(1, "prismatic", limit(0.5, 1)) +
                                    joint(2, "fixed") + joint(3, "continuous") + joint(4, "floating")));
  ASSERT_EQ(kinematics.variables().size(), 3u);
  EXPECT_EQ(kinematics.variables()[0].name, "j0");
  EXPECT_EQ(kinematics.variables()[0].upper, 2);
  EXPECT_EQ(kinematics.variables()[2].lower, -kPi);
  EXPECT_EQ(kinematics.rest(), (Configuration{0, 0.5, 0}));

  const std::vector<Eigen::Isometry3d> poses = kinematics.poses({kPi / 2, 0.75, kPi / 2});
  EXPECT_TRUE(poses[1].translation().isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(poses[2].translation().isApprox(Eigen::Vector3d(1, 1, 0.75)));
  EXPECT_TRUE(poses[3].translation().isApprox(Eigen::Vector3d(1, 2, 0.75)));
  EXPECT_TRUE(poses[4].translation().isApprox(Eigen::Vector3d(1, 3, 0.75)));
  EXPECT_TRUE(poses[5].translation().isApprox(Eigen::Vector3d(0, 3, 0.75))) << "turned by the joint before it";
}

TEST(Kinematics, PosesAreInTheOrderOfTheDocument) {
  const RobotDescription description = robot(
      "<link name=\"tip\"/><link name=\"base\"/><joint name=\"j\" type=\"fixed\"><parent link=\"base\"/><child "
      "link=\"tip\"/><origin xyz=\"0 0 3\"/></joint>");
  const std::vector<Eigen::Isometry3d> poses = Kinematics(description).poses({});
  EXPECT_EQ(poses[0].translation().z(), 3);
  EXPECT_EQ(poses[1].translation().z(), 0);
}

TEST(Kinematics, AtRestAsInTheDescription) {
  const RobotDescription description = readRobotDescription(DEMO_ROBOT "/urdf/demo_arm.urdf");
  const Kinematics kinematics(description);
  const std::vector<Eigen::Isometry3d> poses = kinematics.poses(kinematics.rest());
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_TRUE(poses[i].isApprox(description.links[i].pose)) << description.links[i].name;
}

TEST(Kinematics, RefusesConfigurationsOfAnotherSizeOrWithoutAValue) {
  const Kinematics kinematics(robot(links(3) + joint(0, "prismatic", limit(0, 1)) + joint(1, "prismatic", limit(0, 1))));
  EXPECT_EQ(kinematics.links(), 3u);
  EXPECT_NO_THROW(kinematics.check({0, 7}));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Configuration& wrong : {Configuration{0}, {0, 0, 0}, {0, infinity}, {std::nan(""), 0}})
    expectError(ErrorCode::kBadOption, {"a configuration"}, [&] { kinematics.poses(wrong); });
  expectError(ErrorCode::kBadOption, {"the value inf for joint 'j1'"}, [&] { kinematics.check({0, infinity}); });
}

TEST(Kinematics, MimicJointsFollow) {
  const Kinematics kinematics(robot(links(4) + joint(0, "prismatic", limit(0, 1)) +
                                    joint(1, "prismatic", limit(0, 1) + "<mimic joint=\"j0\" multiplier=\"-2\" offset=\"0.5\"/>") +
                                    joint(2, "prismatic", limit(0, 1) + "<mimic joint=\"j1\" multiplier=\"3\" offset=\"1\"/>")));
  ASSERT_EQ(kinematics.variables().size(), 1u);
  const std::vector<Eigen::Isometry3d> poses = kinematics.poses({0.25});
  EXPECT_NEAR(poses[1].translation().z(), 0.25, 1e-12);
  EXPECT_NEAR(poses[2].translation().z() - poses[1].translation().z(), -2 * 0.25 + 0.5, 1e-12);
  EXPECT_NEAR(poses[3].translation().z() - poses[2].translation().z(), 3 * (-2 * 0.25 + 0.5) + 1, 1e-12);
}

Eigen::Isometry3d linkPose(const Chain& chain, const Configuration& configuration) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const ChainJoint& joint : chain.joints) {
    pose = pose * joint.origin * motion(joint, joint.multiplier * configuration[joint.variable] + joint.offset);
  }
  return pose * chain.end;
}

TEST(Kinematics, ChainsLeadToTheLinks) {
  const Kinematics kinematics(robot(links(6) + joint(0, "fixed") + joint(1, "revolute", limit(-1, 2)) + joint(2, "floating") +
                                    joint(3, "prismatic", limit(0, 1)) +
                                    joint(4, "continuous", "<mimic joint=\"j1\" multiplier=\"-2\" offset=\"0.5\"/>")));
  EXPECT_TRUE(kinematics.chain(0).joints.empty());
  EXPECT_TRUE(kinematics.chain(1).joints.empty());
  EXPECT_EQ(kinematics.chain(1).end.translation().x(), 1);
  EXPECT_EQ(kinematics.chain(5).joints.size(), 3u);
  EXPECT_EQ(kinematics.chain(5).joints[2].variable, 0u);
  const Configuration configuration{0.7, 0.4};
  const std::vector<Eigen::Isometry3d> poses = kinematics.poses(configuration);
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_TRUE(linkPose(kinematics.chain(i), configuration).isApprox(poses[i])) << i;
}

TEST(Kinematics, JointsByName) {
  const Kinematics kinematics(robot(links(4) + joint(0, "fixed") + joint(1, "continuous") +
                                    joint(2, "prismatic", limit(0, 1) + "<mimic joint=\"j1\" multiplier=\"3\" offset=\"1\"/>")));
  const std::vector<NamedJoint> joints = kinematics.joints();
  ASSERT_EQ(joints.size(), 3u);
  EXPECT_EQ(joints[0].variable, -1);
  EXPECT_EQ(joints[1].variable, 0);
  EXPECT_EQ(joints[2].variable, 0);
  EXPECT_EQ(joints[2].multiplier, 3);
  EXPECT_EQ(joints[2].offset, 1);
  EXPECT_TRUE(kinematics.variables()[0].continuous);
}

// Converters write numbers of that size where a joint has no limit, also on one side alone.
TEST(Kinematics, LimitsFarApartAreNone) {
  for (const auto& [lower, upper] : {std::pair(-1e16, 0.0), std::pair(0.0, 2e4), std::pair(-1e5, 1e5)})
    EXPECT_TRUE(Kinematics(robot(links(2) + joint(0, "revolute", limit(lower, upper)))).variables()[0].continuous) << lower;
  EXPECT_FALSE(Kinematics(robot(links(2) + joint(0, "revolute", limit(-100, 100)))).variables()[0].continuous);
}

TEST(Kinematics, MimicsOfMimics) {
  const std::vector<NamedJoint> joints =
      Kinematics(robot(links(4) + joint(0, "prismatic", limit(0, 1) + "<mimic joint=\"j1\" multiplier=\"3\" offset=\"1\"/>") +
                       joint(1, "prismatic", limit(0, 1) + "<mimic joint=\"j2\" multiplier=\"-2\" offset=\"0.5\"/>") +
                       joint(2, "prismatic", limit(0, 1))))
          .joints();
  const double multipliers[] = {-6, -2, 1}, offsets[] = {2.5, 0.5, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(joints[i].variable, 0) << i;
    EXPECT_EQ(joints[i].multiplier, multipliers[i]) << i;
    EXPECT_EQ(joints[i].offset, offsets[i]) << i;
  }
}

TEST(Kinematics, MimicsOfNothing) {
  const auto mimic = [](int i, const std::string& master) {
    return joint(i, "prismatic", limit(0, 1) + "<mimic joint=\"" + master + "\"/>");
  };
  const auto make = [](const std::string& content) { return [content] { Kinematics kinematics(robot(content)); }; };
  expectError(ErrorCode::kNotARobot, {"'j0'", "'nowhere'"}, make(links(2) + mimic(0, "nowhere")));
  expectError(ErrorCode::kNotARobot, {"'j1'", "does not move"}, make(links(3) + joint(0, "fixed") + mimic(1, "j0")));
  expectError(ErrorCode::kNotARobot, {"back to itself"}, make(links(3) + mimic(0, "j1") + mimic(1, "j0")));
}

/// Readers make none of these.
TEST(Kinematics, DescriptionsMadeByHandAreATreeToo) {
  const RobotDescription sound =
      robot(links(3) + joint(0, "revolute", limit(-1, 1)) + joint(1, "revolute", limit(-1, 1) + "<mimic joint=\"j0\"/>"));
  EXPECT_NO_THROW(Kinematics{sound});
  const auto refused = [&](const std::vector<std::string>& parts, const std::function<void(RobotDescription&)>& change) {
    RobotDescription wrong = sound;
    change(wrong);
    expectError(ErrorCode::kNotARobot, parts, [&] { Kinematics{wrong}; });
  };
  refused({"joint 'j1' names link 'l9'", "add the link"}, [](RobotDescription& r) { r.joints[1].child = "l9"; });
  refused({"joint 'j0' names link ''"}, [](RobotDescription& r) { r.joints[0].parent.clear(); });
  refused({"'j1' mimics 'j9'"}, [](RobotDescription& r) { r.joints[1].mimic = "j9"; });
  refused({"joint 'j1' leads to link 'l0'", "one joint"}, [](RobotDescription& r) { r.joints[1].child = "l0"; });
  refused({"joint 'j1' leads to link 'l1'"}, [](RobotDescription& r) { r.joints[1].parent = "l2", r.joints[1].child = "l1"; });
  refused({"joint 'j0' leads to link 'l0'"}, [](RobotDescription& r) { r.joints[0].child = "l0"; });
  refused({"joint 'j0' leads to link 'l1'", "nearest to the root first"}, [](RobotDescription& r) { std::swap(r.joints[0], r.joints[1]); });
  refused({"link 'l1' appears twice"}, [](RobotDescription& r) { r.links[2].name = "l1"; });
  refused({"joint 'j0' appears twice"}, [](RobotDescription& r) { r.joints[1].name = "j0"; });
  refused({"joint 'j0' has the limits 1 and -1"}, [](RobotDescription& r) { std::swap(r.joints[0].lower, r.joints[0].upper); });
  refused({"joint 'j0' has the limits nan and 1"}, [](RobotDescription& r) { r.joints[0].lower = std::nan(""); });
  refused({"joint 'j0' has the limits -1 and inf"},
          [](RobotDescription& r) { r.joints[0].upper = std::numeric_limits<double>::infinity(); });
  refused({"joint 'j0' has an axis of length 2"}, [](RobotDescription& r) { r.joints[0].axis *= 2; });
}

TEST(Kinematics, NamedValues) {
  const Kinematics kinematics(robot(links(4) + joint(0, "revolute", limit(-1, 1)) + joint(1, "continuous") + joint(2, "fixed")));
  EXPECT_EQ(kinematics.configuration({}), kinematics.rest());
  EXPECT_EQ(kinematics.configuration({{"j1", -2}}), (Configuration{0, -2}));
  EXPECT_EQ(kinematics.configuration({{"j0", 1 + 1e-9}})[0], 1 + 1e-9);
  const auto set = [&](const std::string& name, double value) {
    return [&kinematics, name, value] { kinematics.configuration({{name, value}}); };
  };
  expectError(ErrorCode::kBadOption, {"'elbow'"}, set("elbow", 0));
  expectError(ErrorCode::kBadOption, {"'j2'"}, set("j2", 0));
  expectError(ErrorCode::kBadOption, {"'j0'", "1.5", "limits"}, set("j0", 1.5));
  expectError(ErrorCode::kBadOption, {"'j1'"}, set("j1", std::nan("")));
  expectError(ErrorCode::kBadOption, {"size 1 was given; the size has to be 2, a value for each joint"}, [&] { kinematics.poses({0}); });
}

TEST(Kinematics, LimitsAllowForDecimalText) {
  const JointVariable joint{"elbow", -1, 2};
  EXPECT_TRUE(withinLimits(joint, 2 + 1e-6) && withinLimits(joint, -1 - 1e-6));
  EXPECT_FALSE(withinLimits(joint, 2 + 3e-6) || withinLimits(joint, -1 - 3e-6) || withinLimits(joint, std::nan("")));
  EXPECT_EQ(beyondLimits(joint, 3), "joint 'elbow' at 3.000000 is beyond its limits, -1.000000 to 2.000000");
  EXPECT_EQ(beyondLimits(joint, -90),
            "joint 'elbow' at -90.000000 is beyond its limits, -1.000000 to 2.000000; positions are in radians, or metres");
}

TEST(Kinematics, EqualJointsAgreeInAll) {
  const ChainJoint joint;
  EXPECT_TRUE(equalJoints(joint, joint));
  ChainJoint other = joint;
  other.turns = false;
  EXPECT_FALSE(equalJoints(joint, other));
  other = joint;
  other.variable = 1;
  EXPECT_FALSE(equalJoints(joint, other));
  other = joint;
  other.multiplier = 2;
  EXPECT_FALSE(equalJoints(joint, other));
  other = joint;
  other.offset = 1;
  EXPECT_FALSE(equalJoints(joint, other));
  other = joint;
  other.axis = Eigen::Vector3d::UnitY();
  EXPECT_FALSE(equalJoints(joint, other));
  other = joint;
  other.origin.translation().x() = 1;
  EXPECT_FALSE(equalJoints(joint, other));
}

TEST(Kinematics, CrossedLimitsKeepTheJointAtZero) {
  const Kinematics kinematics(robot(links(2) + joint(0, "revolute", limit(1, -1))));
  EXPECT_EQ(kinematics.sample([] { return 0.7; }), (Configuration{0}));
}

TEST(Kinematics, SamplesStayWithinTheLimits) {
  const Kinematics kinematics(readRobotDescription(DEMO_ROBOT "/urdf/demo_arm.urdf"));
  std::mt19937_64 engine(7);
  for (int i = 0; i < 100; ++i) {
    const Configuration sample = kinematics.sample([&] { return static_cast<double>(engine() >> 11) * 0x1p-53; });
    for (std::size_t k = 0; k < sample.size(); ++k) {
      EXPECT_GE(sample[k], kinematics.variables()[k].lower);
      EXPECT_LE(sample[k], kinematics.variables()[k].upper);
    }
    for (const Eigen::Isometry3d& pose : kinematics.poses(sample)) {
      EXPECT_TRUE((pose.linear() * pose.linear().transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-12));
    }
  }
}

/// From link `parent` to link `child`.
std::string joined(const std::string& type, const std::string& parent, const std::string& child) {
  return "<joint name=\"" + parent + "_" + child + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + limit(-1, 1) + "</joint>";
}

TEST(Kinematics, AdjacentLinks) {
  const Kinematics kinematics(
      robot(links(5) + joint(0, "revolute", limit(-1, 1)) + joint(1, "fixed") + joint(2, "fixed") + joint(3, "prismatic", limit(0, 1))));
  EXPECT_TRUE(kinematics.adjacent(0, 1));
  EXPECT_TRUE(kinematics.adjacent(1, 2)) << "fixed to each other";
  EXPECT_TRUE(kinematics.adjacent(1, 3)) << "fixed to each other";
  EXPECT_TRUE(kinematics.adjacent(3, 4));
  EXPECT_FALSE(kinematics.adjacent(0, 4));
}

TEST(Kinematics, WhatIsFixedToAJointsLinkIsNoNeighbourAcrossTheJoint) {
  const std::string box = "<collision><geometry><box size=\"1 1 1\"/></geometry></collision>";
  std::string text;
  std::map<std::string, std::size_t> index;
  const auto add = [&](const std::string& name, bool is_bare) {
    index.emplace(name, index.size());
    text += "<link name=\"" + name + "\">" + (is_bare ? "" : box) + "</link>";
  };
  for (const char* const name : {"base", "mast", "arm", "camera", "tool", "grip", "hand", "thumb"}) add(name, false);
  for (const char* const name : {"elbow", "flange", "world", "plate", "palm"}) add(name, true);
  const Kinematics kinematics(
      robot(text + joined("fixed", "world", "base") + joined("fixed", "base", "mast") + joined("revolute", "base", "arm") +
            joined("fixed", "arm", "camera") + joined("fixed", "arm", "elbow") + joined("fixed", "elbow", "flange") +
            joined("revolute", "flange", "tool") + joined("revolute", "tool", "plate") + joined("fixed", "plate", "palm") +
            joined("fixed", "palm", "grip") + joined("revolute", "grip", "hand") + joined("fixed", "elbow", "thumb")));
  const auto adjacent = [&](const std::string& a, const std::string& b) {
    EXPECT_EQ(kinematics.adjacent(index.at(a), index.at(b)), kinematics.adjacent(index.at(b), index.at(a)));
    return kinematics.adjacent(index.at(a), index.at(b));
  };
  EXPECT_TRUE(adjacent("base", "arm"));
  EXPECT_TRUE(adjacent("base", "mast")) << "fixed to each other";
  EXPECT_FALSE(adjacent("mast", "arm")) << "the arm may swing into it";
  EXPECT_FALSE(adjacent("base", "camera"));
  EXPECT_TRUE(adjacent("tool", "grip")) << "plate and palm have no geometry";
  EXPECT_TRUE(adjacent("grip", "hand"));
  EXPECT_FALSE(adjacent("arm", "tool")) << "two links are fixed to elbow and flange; which of them touches the tool?";
  EXPECT_FALSE(adjacent("thumb", "tool"));
  EXPECT_FALSE(adjacent("camera", "tool"));
}

TEST(Kinematics, LinksAreSettledUnlessAJointBetweenThemIsOpen) {
  const Kinematics afloat(robot(links(4) + joint(0, "floating") + joint(1, "fixed") + joint(2, "revolute", limit(-1, 1))));
  EXPECT_FALSE(afloat.settled(0, 1));
  EXPECT_FALSE(afloat.settled(0, 3));
  EXPECT_TRUE(afloat.settled(1, 3));
  EXPECT_TRUE(afloat.settled(3)) << "against the world a floating joint stays";
  EXPECT_TRUE(afloat.adjacent(0, 1));
  EXPECT_TRUE(afloat.adjacent(1, 2)) << "fixed to each other";
  EXPECT_FALSE(afloat.adjacent(0, 3));
  ASSERT_EQ(afloat.notes().size(), 1u);
  EXPECT_NE(afloat.notes()[0].find("'j0' floats"), std::string::npos);

  const auto geared = [](const std::string& type, const std::string& ratio) {
    return Kinematics(
        robot(links(3) + joint(0, "continuous") + joint(1, type, limit(-1, 1) + "<mimic joint=\"j0\" multiplier=\"" + ratio + "\"/>")));
  };
  EXPECT_TRUE(geared("continuous", "-2").settled(1, 2));
  EXPECT_TRUE(geared("prismatic", "0").settled(1, 2));
  for (const auto& [type, ratio] : {std::pair("continuous", "0.25"), std::pair("revolute", "1.5"), std::pair("prismatic", "1")}) {
    EXPECT_FALSE(geared(type, ratio).settled(1, 2)) << type;
    EXPECT_FALSE(geared(type, ratio).settled(2)) << type;
    EXPECT_TRUE(geared(type, ratio).settled(1)) << type;
    EXPECT_EQ(geared(type, ratio).notes().size(), 1u);
  }
}

TEST(Kinematics, SaysWhichJointsHaveNoRoom) {
  for (const std::string& limits : {limit(1, -1), limit(0, 0), std::string("<limit effort='1' velocity='1'/>")}) {
    const std::vector<std::string> notes = Kinematics(robot(links(2) + joint(0, "revolute", limits))).notes();
    ASSERT_EQ(notes.size(), 1u) << limits;
    EXPECT_NE(notes[0].find("'j0'"), std::string::npos);
  }
  EXPECT_TRUE(Kinematics(robot(links(2) + joint(0, "revolute", limit(-1, 1)))).notes().empty());
}

TEST(Kinematics, NumbersBeyondAllMeasure) {
  const auto load = [](const std::string& content) { return [content] { Kinematics{robot(links(2) + content)}; }; };
  expectError(ErrorCode::kNotARobot, {"'j0'", "<origin>"},
              load("<joint name='j0' type='fixed'><parent link='l0'/><child link='l1'/><origin xyz='1e300 0 0'/></joint>"));
  expectError(ErrorCode::kNotARobot, {"'j0'", "axis 0 0 0"},
              load("<joint name='j0' type='continuous'><parent link='l0'/><child link='l1'/><axis xyz='0 0 0'/></joint>"));
  const Kinematics endless(robot(links(2) + joint(0, "revolute", "<limit lower='-1e16' upper='1e16' effort='1' velocity='1'/>")));
  EXPECT_TRUE(endless.variables()[0].continuous) << "what converters write where there is no limit";
  const Kinematics sliding(robot(links(2) + joint(0, "prismatic", "<limit lower='-1e300' upper='1e300' effort='1' velocity='1'/>")));
  EXPECT_TRUE(sliding.variables().empty());
  EXPECT_FALSE(sliding.settled(0, 1));
  EXPECT_EQ(sliding.notes(), std::vector<std::string>{"joint 'j0' slides more than 1000 km: it stays at its origin, and nothing is proved "
                                                      "between links on opposite sides of it"});
}

TEST(Kinematics, MimicsBeyondAllMeasure) {
  const auto load = [](const std::string& kind, const std::string& numbers) {
    const std::string mimic = "<mimic joint=\"j0\" " + numbers + "/>";
    return [=] { Kinematics{robot(links(3) + joint(0, "revolute", limit(-1, 2)) + joint(1, kind, limit(-1, 1) + mimic))}; };
  };
  expectError(ErrorCode::kNotARobot, {"'j1' follows 'j0' from -1e+307 to 2e+307 m", "1000 km", "<mimic>"},
              load("prismatic", "multiplier='1e307'"));
  expectError(ErrorCode::kNotARobot, {"'j1'", "1000 km", "<mimic>"}, load("prismatic", "multiplier='1e6'"));
  EXPECT_NO_THROW(load("prismatic", "multiplier='4e5'")());
  expectError(ErrorCode::kNotARobot, {"'j1' follows 'j0'", "rad, which is not a range", "<mimic>"},
              load("revolute", "multiplier='1.5e308'"));
  std::string chain = links(101) + joint(0, "revolute", limit(-1, 1));
  for (int i = 1; i < 100; ++i)
    chain += joint(i, "revolute", limit(-1, 1) + "<mimic joint=\"j" + std::to_string(i - 1) + "\" multiplier=\"1e9\"/>");
  expectError(ErrorCode::kNotARobot, {"which is not a range", "<mimic>"}, [&] { Kinematics{robot(chain)}; });
}

TEST(Kinematics, ManyFloatingJointsAboveManyLinks) {
  std::string text = links(3000);
  for (int i = 0; i < 1000; ++i) text += joint(i, "floating");
  for (int i = 1001; i < 2900; ++i)
    text += "<joint name=\"j" + std::to_string(i) + "\" type=\"fixed\"><parent link=\"l1000\"/><child link=\"l" + std::to_string(i) +
            "\"/></joint>";
  for (int i = 2900; i < 3000; ++i)
    text += "<joint name=\"j" + std::to_string(i) + "\" type=\"fixed\"><parent link=\"l0\"/><child link=\"l" + std::to_string(i) +
            "\"/></joint>";
  expectError(ErrorCode::kNotARobot, {"more than a million"}, [&] { Kinematics{robot(text)}; });
}

TEST(Kinematics, MimicsRestWhereTheirMasterPutsThem) {
  const RobotDescription description = robot(links(3) + joint(0, "revolute", limit(0.5, 1)) +
                                             joint(1, "revolute", limit(-1, 1) + "<mimic joint=\"j0\" multiplier=\"2\" offset=\"0.25\"/>"));
  const Kinematics kinematics(description);
  const std::vector<Eigen::Isometry3d> poses = kinematics.poses(kinematics.rest());
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(poses[i].isApprox(description.links[i].pose, 1e-12)) << i;
  EXPECT_NEAR(Eigen::AngleAxisd(poses[2].linear()).angle(), 0.5 + 1.25, 1e-12);
}

}  // namespace
}  // namespace collision_hulls
