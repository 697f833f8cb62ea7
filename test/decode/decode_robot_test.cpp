// Also tests src/decode/urdf/geometry_stand_ins.cpp, src/decode/urdf/urdf_elements.cpp, src/decode/urdf/urdf_model.cpp and
// src/decode/urdf/urdfdom_losses.cpp.
#include <gtest/gtest.h>

#include <locale>
#include <thread>

#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

const double kRounding = 1e-15;

std::string robotWith(const std::string& content) {
  return "<robot name=\"r\">\n" + content + "\n</robot>\n";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& more) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" + more +
         "</joint>\n";
}

// Rubbish.

void expectRefused(ErrorCode code, const std::vector<std::string>& parts, const std::string& text) {
  expectError(code, parts, [&] { parseRobotDescription(text, "a.urdf"); });
}

TEST(ParseDescription, RefusesWhatIsNotXml) {
  expectRefused(ErrorCode::kNotXml, {"'a.urdf'", "it is empty"}, "");
  expectRefused(ErrorCode::kNotXml, {"line 2", "outside the root"}, "\nsolid cube");
  expectRefused(ErrorCode::kNotXml, {"line 3", "</robot>", "<link> of line 2"}, "<robot name='r'>\n<link name='a'>\n</robot>");
  expectRefused(ErrorCode::kNotXml, {"line 1", "zero byte"}, std::string("<robot\0/>", 9));
  expectRefused(ErrorCode::kNotXml, {"UTF-16"}, std::string("\xFF\xFE<\0", 4));
  expectRefused(ErrorCode::kNotXml, {"line 3", "attribute 'name' of <link> appears twice; remove one"},
                "<!-- -->\n<robot name='r'>\n<link name='a' name='b'/></robot>");
  expectRefused(ErrorCode::kNotXml, {"line 3", "XML_ERROR_PARSING_ELEMENT"}, "<!-- -->\n<robot name='r'>\n<link 1='a'/></robot>");
}

TEST(ParseDescription, RefusesNestingThatXmlReadersDoNotFollow) {
  std::string text = "<robot name='r'><link name='a'>";
  for (int i = 0; i < 5000; ++i) text += "<a>";
  for (int i = 0; i < 5000; ++i) text += "</a>";
  expectRefused(ErrorCode::kNotXml, {"nest deeper"}, text + "</link></robot>");
}

TEST(ParseDescription, RefusesWhatIsNoRobot) {
  expectRefused(ErrorCode::kNotARobot, {"line 2", "<sdf>"}, "<?xml version='1.0'?>\n<sdf><robot/></sdf>");
  expectRefused(ErrorCode::kNotARobot, {"No name given for the robot"}, "<robot><link name='a'/></robot>");
  expectRefused(ErrorCode::kNotARobot, {"line 3", "<link> has no name"}, robotWith("<link name='a'/>\n<link/>"));
  expectRefused(ErrorCode::kNotARobot, {"line 2", "<link> has no name"}, robotWith("<link name=''/>"));
  expectRefused(ErrorCode::kNotARobot, {"link 'a' is not unique"}, robotWith("<link name='a'/><link name='a'/>"));
  expectRefused(ErrorCode::kNotARobot, {"Two root links"}, robotWith("<link name='a'/><link name='b'/>"));
  expectRefused(ErrorCode::kNotARobot, {"version"}, "<robot name='r' version='7.1'><link name='a'/></robot>");
}

TEST(ParseDescription, RefusesRobotsWithoutLinks) {
  expectRefused(ErrorCode::kNoLinks, {"line 1", "no <link>"}, "<robot name='r'/>");
  expectRefused(ErrorCode::kNoLinks, {"no <link>"}, robotWith("<gazebo><link name='a'/></gazebo><!-- <link name='b'/> -->"));
}

TEST(ParseDescription, SuspectsXacro) {
  expectRefused(ErrorCode::kNoLinks, {"<xacro:include> in line 2", ".xacro"}, robotWith("<xacro:include filename='x'/>"));
}

TEST(ParseDescription, NotesWhatXacroLeftOrNeverSaw) {
  EXPECT_TRUE(parseRobotDescription(robotWith("<link name='a'/><!-- <xacro:if/> -->")).notes.empty());
  const auto notes = parseRobotDescription(robotWith("<link name='a'/>\n<xacro:include filename='x'/><xacro:y/>"), "a.urdf").notes;
  ASSERT_EQ(notes.size(), 1u);
  for (const std::string part : {"'a.urdf'", "<xacro:include> in line 3", ".xacro"})
    EXPECT_NE(notes[0].find(part), std::string::npos) << notes[0];
}

TEST(ParseDescription, RefusesLoopsOfJoints) {
  const std::string links = "<link name='r'/><link name='a'/>\n<link name='b'/>";
  const std::string loop = joint("j", "fixed", "a", "b", "") + joint("k", "fixed", "b", "a", "");
  expectRefused(ErrorCode::kNotARobot, {"line 2", "link 'a'", "loop"}, robotWith(links + loop));
  expectRefused(ErrorCode::kNotARobot, {"loop"}, robotWith("<link name='a'/>" + joint("j", "fixed", "a", "a", "")));
}

TEST(ParseDescription, RefusesEndlessChainsOfJoints) {
  const auto chain = [](int links) {
    std::string text;
    for (int i = 0; i < links; ++i) text += "<link name='" + std::to_string(i) + "'/>";
    for (int i = 1; i < links; ++i) text += joint(std::to_string(i), "fixed", std::to_string(i - 1), std::to_string(i), "");
    return robotWith(text);
  };
  EXPECT_EQ(parseRobotDescription(chain(2001)).links.size(), 2001u);
  expectRefused(ErrorCode::kNotARobot, {"2000 joints", "'2001'"}, chain(2002));
}

// urdfdom goes on after an element that it cannot read and drops the rest of the link.
TEST(ParseDescription, ElementsThatCannotBeReadHaveAFaultAndLeaveTheOthersAlone) {
  const std::string good = "<collision name='good'><geometry><box size='1 1 1'/></geometry></collision>";
  const auto check = [&](const std::string& kind, const std::string& bad, const std::string& uri, const std::string& reason) {
    const std::string element = "\n<" + kind + " name='bad'>" + bad + "</" + kind + ">";
    const RobotDescription robot = parseRobotDescription(robotWith("<link name='a'>" + good + element + good + "</link>"));
    const LinkDescription& link = robot.links.at(0);
    const std::vector<GeometryElement>& elements = kind == "visual" ? link.visuals : link.collisions;
    ASSERT_EQ(link.visuals.size() + link.collisions.size(), 3U);
    const GeometryElement& found = elements.at(kind == "visual" ? 0 : 1);
    EXPECT_EQ(found.name, "bad");
    EXPECT_EQ(found.uri, uri);
    EXPECT_EQ(found.kind, GeometryElement::Kind::kMesh);
    for (const std::string& part : {std::string("line 3"), "<" + kind + ">", std::string("link 'a'"), reason})
      EXPECT_NE(found.fault.find(part), std::string::npos) << found.fault;
    EXPECT_EQ(link.collisions.back().kind, GeometryElement::Kind::kBox);
    EXPECT_EQ(link.collisions.back().fault, "");
    ASSERT_EQ(robot.notes.size(), 1U);
    EXPECT_NE(robot.notes[0].find("urdfdom"), std::string::npos) << robot.notes[0];
  };
  for (const char* kind : {"visual", "collision"}) {
    check(kind, "<geometry><capsule/></geometry>", "<capsule>", "capsule");
    for (const std::string scale : {"0.001", "1 1", "1e300", "1 1 1 1", "1e400 1 1", "1,1,1", ""})
      check(kind, "<geometry><mesh filename='a.stl' scale='" + scale + "'/></geometry>", "a.stl",
            "has the scale '" + scale + "'; give three finite numbers");
    check(kind, "<origin xyz='1e999 0 0'/><geometry><sphere radius='1'/></geometry>", "<sphere>", "");
    check(kind, "<origin xyz='0 0'/><geometry><mesh filename='b.stl'/></geometry>", "b.stl", "3 expected");
  }
}

TEST(ParseDescription, ElementsWithoutGeometryAreNone) {
  for (const char* empty :
       {"<visual/>", "<visual><geometry/></visual>", "<visual><material name='m'><color rgba='1 0 0 1'/></material></visual>"}) {
    const RobotDescription robot = parseRobotDescription(robotWith(
        std::string("\n<link name='a'>") + empty + "<visual><geometry><sphere radius='1'/></geometry></visual><collision/></link>"));
    ASSERT_EQ(robot.links.at(0).visuals.size(), 2U);
    EXPECT_EQ(robot.links[0].visuals[0].kind, GeometryElement::Kind::kNone);
    EXPECT_EQ(robot.links[0].visuals[1].kind, GeometryElement::Kind::kSphere);
    ASSERT_EQ(robot.links[0].collisions.size(), 1U);
    EXPECT_EQ(robot.links[0].collisions[0].kind, GeometryElement::Kind::kNone);
    ASSERT_EQ(robot.notes.size(), 2U);
    EXPECT_NE(robot.notes[0].find("line 3: this <visual> of link 'a' has no geometry"), std::string::npos) << robot.notes[0];
    EXPECT_TRUE(sourceElements(robot.links[0], Source::kAuto).visual) << "its collision is none";
  }
}

// Nor are materials.
TEST(ParseDescription, InertiaIsNoneOfItsBusiness) {
  const std::string box = "<geometry><box size='1 1 1'/></geometry>", collision = "<collision>" + box + "</collision>";
  for (const std::string bad : {"<inertial/>", "<inertial><mass value='1'/><inertia ixx='--0'/></inertial>"}) {
    const RobotDescription robot = parseRobotDescription(robotWith("<link name='a'>" + bad + collision + collision + "</link>"));
    EXPECT_EQ(robot.links.at(0).collisions.size(), 2U);
    ASSERT_EQ(robot.notes.size(), 1U) << "urdfdom, and so rviz, sees no collision element";
    for (const std::string part : {"line 2", "<inertial> of link 'a'", "0 of its 0 <visual> and 0 of its 2 <collision>"})
      EXPECT_NE(robot.notes[0].find(part), std::string::npos) << robot.notes[0];
  }
  std::string links;
  for (const char* name : {"a", "b", "c"})
    links += "<link name='" + std::string(name) + "'><visual>" + box + "<material/></visual>" + collision + "</link>" +
             (*name > 'a' ? joint(name, "fixed", "a", name, "") : "");
  const RobotDescription robot = parseRobotDescription(robotWith(links));
  EXPECT_EQ(robot.links.at(2).collisions.size(), 1U);
  ASSERT_EQ(robot.notes.size(), 1U);
  for (const std::string part : {"<visual> of link 'a'", "0 of its 1 <visual> and 0 of its 1 <collision>", "2 more links: 'b', 'c'"})
    EXPECT_NE(robot.notes[0].find(part), std::string::npos) << robot.notes[0];
  const std::string good = "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";
  EXPECT_TRUE(parseRobotDescription(robotWith("<link name='a'>" + good + collision + "</link>")).notes.empty());
}

// As rviz and MoveIt do; what others may see, a note names.
TEST(ParseDescription, OfSeveralShapesTheFirstCounts) {
  const std::string box = "<box size='1 1 1'/>", ball = "<sphere radius='1'/>";
  for (const std::string& shapes : {box + ball, box + "<!-- ball -->" + ball, box + "</geometry><geometry>" + ball}) {
    const std::string link = "<link name='a'><collision><geometry>" + shapes + "</geometry></collision></link>";
    const RobotDescription robot = parseRobotDescription(robotWith(link));
    ASSERT_EQ(robot.links.at(0).collisions.size(), 1U);
    EXPECT_EQ(robot.links[0].collisions[0].kind, GeometryElement::Kind::kBox);
    ASSERT_EQ(robot.notes.size(), 1U) << shapes;
    for (const std::string part : {"line 2", "this <sphere> of link 'a' is a second shape", "a <visual> or <collision> of its own"})
      EXPECT_NE(robot.notes[0].find(part), std::string::npos) << robot.notes[0];
  }
  const std::string other = "<link name='a'><visual><geometry>" + box + "<colour/></geometry></visual></link>";
  EXPECT_TRUE(parseRobotDescription(robotWith(other)).notes.empty()) << "no shape";
}

TEST(ParseDescription, KeepsUrdfdomQuiet) {
  testing::internal::CaptureStderr();
  EXPECT_THROW(parseRobotDescription("<robot><link name='a'/></robot>"), Error);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Meaning.

TEST(ParseDescription, KeepsTextPathAndOrder) {
  const std::string text =
      robotWith("<link name='z'/><link name='a'/><link name='m'/>" + joint("j", "fixed", "z", "a", "") + joint("k", "fixed", "z", "m", ""));
  const RobotDescription robot = parseRobotDescription(text, "some/where.urdf");
  EXPECT_EQ(robot.name, "r");
  EXPECT_EQ(robot.text, text);
  EXPECT_EQ(robot.path, "some/where.urdf");
  ASSERT_EQ(robot.links.size(), 3u);
  EXPECT_EQ(robot.links[0].name, "z");
  EXPECT_EQ(robot.links[1].name, "a");
  EXPECT_EQ(robot.links[2].name, "m");
  EXPECT_EQ(robot.links[0].parent, "");
  EXPECT_EQ(robot.links[2].parent, "z");
}

TEST(ParseDescription, ReadsElementsInOrder) {
  const RobotDescription robot = parseRobotDescription(robotWith(R"(<link name="a">
    <visual name="one" group="high"><geometry><mesh filename="package://p/a b.dae" scale="1 -2 0.5"/></geometry></visual>
    <collision><geometry><cylinder length="3" radius="0.25"/></geometry></collision>
    <visual><origin xyz="1 2 3"/><geometry><mesh filename="b.stl"/></geometry></visual>
    <collision name="s"><geometry><sphere radius="2"/></geometry></collision>
    <collision><geometry><box size="1 2 3"/></geometry></collision></link>)"));
  using Kind = GeometryElement::Kind;
  const LinkDescription& link = robot.links.at(0);
  ASSERT_EQ(link.visuals.size(), 2u);
  ASSERT_EQ(link.collisions.size(), 3u);
  EXPECT_EQ(link.visuals[0].name, "one");
  EXPECT_EQ(link.visuals[0].uri, "package://p/a b.dae");
  EXPECT_EQ(link.visuals[0].scale, Eigen::Vector3d(1, -2, 0.5));
  EXPECT_EQ(link.visuals[1].name, "");
  EXPECT_EQ(link.visuals[1].scale, Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(link.visuals[1].origin.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(link.collisions[0].kind, Kind::kCylinder);
  EXPECT_EQ(link.collisions[0].size, Eigen::Vector3d(0.25, 3, 0));
  EXPECT_EQ(link.collisions[1].kind, Kind::kSphere);
  EXPECT_EQ(link.collisions[1].size.x(), 2);
  EXPECT_EQ(link.collisions[2].kind, Kind::kBox);
  EXPECT_EQ(link.collisions[2].size, Eigen::Vector3d(1, 2, 3));
}

TEST(ParseDescription, DecodesEntities) {
  const RobotDescription robot = parseRobotDescription(
      robotWith("<link name='a&amp;&lt;&#98;'><visual><geometry><mesh filename='x&amp;y.stl'/></geometry></visual></link>"));
  EXPECT_EQ(robot.links.at(0).name, "a&<b");
  EXPECT_EQ(robot.links[0].visuals.at(0).uri, "x&y.stl");
}

TEST(ParseDescription, ReadsPastADocumentType) {
  const std::string text = "\xEF\xBB\xBF<?xml version='1.0'?>\n<!DOCTYPE robot [ <!ENTITY x \"y>\"> ]>\n" + robotWith("<link name='a'/>");
  EXPECT_EQ(parseRobotDescription(text).links.size(), 1u);
}

TEST(ParseDescription, ReadsPastProcessingInstructions) {
  const std::string text = robotWith("<?p <link/>\n ?><link name='a'><?q ?></link>");
  EXPECT_EQ(parseRobotDescription(text).links.size(), 1u);
  expectRefused(ErrorCode::kNotARobot, {"line 4"}, robotWith("<?p\n?>\n<link/>"));
}

TEST(ParseDescription, OriginIsFixedAxisRollPitchYaw) {
  const RobotDescription robot =
      parseRobotDescription(robotWith("<link name='a'><visual><origin rpy='1.5707963267948966 0 1.5707963267948966'/><geometry><sphere "
                                      "radius='1'/></geometry></visual></link>"));
  Eigen::Matrix3d expected;
  expected << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_LT((robot.links.at(0).visuals.at(0).origin.linear() - expected).norm(), kRounding);
}

TEST(ParseDescription, PosesAddUpAlongTheTree) {
  const RobotDescription robot = parseRobotDescription(
      robotWith("<link name='a'/><link name='b'/><link name='c'/>" + joint("k", "fixed", "b", "c", "<origin xyz='1 0 0'/>") +
                joint("j", "continuous", "a", "b", "<origin xyz='0 0 2' rpy='0 0 1.5707963267948966'/><axis xyz='0 0 1'/>")));
  EXPECT_LT((robot.links[1].pose.translation() - Eigen::Vector3d(0, 0, 2)).norm(), kRounding);
  EXPECT_LT((robot.links[2].pose.translation() - Eigen::Vector3d(0, 1, 2)).norm(), kRounding);
}

Eigen::Isometry3d poseBehind(const std::string& type, const std::string& limit) {
  const std::string more = "<axis xyz='0 0 2'/><limit effort='1' velocity='1' " + limit + "/>";
  return parseRobotDescription(robotWith("<link name='a'/><link name='b'/>" + joint("j", type, "a", "b", more))).links.at(1).pose;
}

TEST(ParseDescription, JointsStandAtZeroOrTheNearestLimit) {
  EXPECT_TRUE(poseBehind("prismatic", "lower='-1' upper='1'").isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_NEAR(poseBehind("prismatic", "lower='0.5' upper='1'").translation().z(), 0.5, kRounding);
  EXPECT_NEAR(poseBehind("prismatic", "lower='-1' upper='-0.25'").translation().z(), -0.25, kRounding);
  EXPECT_NEAR(Eigen::AngleAxisd(poseBehind("revolute", "lower='0.5' upper='1'").linear()).angle(), 0.5, kRounding);
  EXPECT_TRUE(poseBehind("revolute", "lower='1' upper='0.5'").isApprox(Eigen::Isometry3d::Identity()));
}

TEST(ParseDescription, ALinkOfTwoJointsIsPlacedOnce) {
  const RobotDescription robot = parseRobotDescription(
      robotWith("<link name='a'/><link name='b'/><link name='c'/>" + joint("i", "fixed", "a", "b", "") +
                joint("j", "fixed", "a", "c", "<origin xyz='1 0 0'/>") + joint("k", "fixed", "b", "c", "<origin xyz='2 0 0'/>")));
  EXPECT_EQ(robot.links[2].parent, "b");
  EXPECT_EQ(robot.links[2].pose.translation().x(), 2);
}

struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(ParseDescription, NumbersDoNotDependOnTheLocale) {
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  const RobotDescription robot = parseRobotDescription(
      robotWith("<link name='a'><visual><origin xyz='0.5 1e-3 0'/><geometry><sphere radius='1.25'/></geometry></visual></link>"));
  std::locale::global(old);
  EXPECT_EQ(robot.links.at(0).visuals.at(0).size.x(), 1.25);
  EXPECT_EQ(robot.links[0].visuals[0].origin.translation(), Eigen::Vector3d(0.5, 0.001, 0));
}

TEST(ParseDescription, ThreadsDoNotMixTheirMessages) {
  const auto complain = [](const std::string& name) {
    for (int i = 0; i < 50; ++i) {
      expectError(ErrorCode::kNotARobot, {"link '" + name + "' is not unique"},
                  [&] { parseRobotDescription(robotWith("<link name='" + name + "'/><link name='" + name + "'/>")); });
    }
  };
  std::thread other(complain, "x");
  complain("y");
  other.join();
}

TEST(ParseDescription, ANameThatATerminalWouldObey) {
  expectError(ErrorCode::kNotARobot, {"line 1", "the name of this <link> holds a control character"},
              [] { parseRobotDescription("<robot name='r'><link name='a\033]0;b\007'/></robot>"); });
  EXPECT_NO_THROW(parseRobotDescription("<robot name='r'><link name='a\u00e9 b'/></robot>"));
}

TEST(ParseDescription, ALinkNameThatIsTooLong) {
  const auto robot = [](std::size_t length) { return "<robot name='r'><link name='" + std::string(length, 'a') + "'/></robot>"; };
  EXPECT_NO_THROW(parseRobotDescription(robot(1000)));
  expectError(ErrorCode::kNotARobot, {"line 1", "the name of this <link>", "longer than 1000 bytes"},
              [&] { parseRobotDescription(robot(1001)); });
  const std::string name(1001, 'a');
  expectError(ErrorCode::kNotARobot, {"the name of this <robot>"},
              [&] { parseRobotDescription("<robot name='" + name + "'><link name='a'/></robot>"); });
  expectError(ErrorCode::kNotARobot, {"the name of this <joint>"}, [&] {
    parseRobotDescription("<robot name='r'><link name='a'/><link name='b'/><joint name='" + name +
                          "' type='fixed'><parent link='a'/><child link='b'/></joint></robot>");
  });
}

TEST(ParseDescription, ElementsThatCannotBeReadKeepTheirPlaces) {
  const std::string box = "<visual><geometry><box size='1 1 1'/></geometry></visual>", none = "<visual/>",
                    capsule = "<visual><geometry><capsule/></geometry></visual>";
  const RobotDescription robot = parseRobotDescription("<robot name='r'><link name='a'>" + none + box + capsule + capsule + none + box +
                                                       none + capsule + "</link><link name='b'>" + capsule + "</link>" +
                                                       "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>");
  std::string kinds;
  for (const GeometryElement& element : robot.links.at(0).visuals) {
    kinds += element.kind == GeometryElement::Kind::kBox ? 'b' : element.kind == GeometryElement::Kind::kNone ? '-' : 'x';
    EXPECT_EQ(element.fault.empty(), kinds.back() != 'x');
  }
  EXPECT_EQ(kinds, "-bxx-b-x");
  EXPECT_EQ(robot.links.at(1).visuals.size(), 1u);
}

TEST(ParseDescription, ALongChainOfMimics) {
  constexpr int kJoints = 16500;  // a recursion over them might need more than a stack
  std::string text = "<robot name='r'><link name='a0'/>";
  for (int i = 1; i <= kJoints; ++i) {
    const std::string number = std::to_string(i);
    text += "<link name='a" + number + "'/><joint name='j" + number + "' type='prismatic'><parent link='a0'/><child link='a" + number +
            "'/><limit lower='-1' upper='1' effort='1' velocity='1'/>" +
            (i > 1 ? "<mimic joint='j" + std::to_string(i - 1) + "' offset='0.5'/>" : "") + "</joint>";
  }
  const RobotDescription robot = parseRobotDescription(text + "</robot>");
  EXPECT_DOUBLE_EQ(robot.links.back().pose.translation().x(), 0.5 * (kJoints - 1));
}

// Products of such coordinates overflow, of which FCL knows nothing: it ends the program.
TEST(ParseDescription, NothingIsAThousandKilometresAway) {
  for (const std::string far : {"1.001e6 0 0", "0 -1e308 0", "0 0 1e300"}) {
    const std::string origin = "<origin xyz='" + far + "'/>";
    expectError(ErrorCode::kNotARobot, {"joint 'j'", "1000 km", "<origin>"},
                [&] { parseRobotDescription(robotWith("<link name='a'/><link name='b'/>" + joint("j", "fixed", "a", "b", origin))); });
    for (const std::string kind : {"visual", "collision"}) {
      const std::string element = "<" + kind + ">" + origin + "<geometry><mesh filename='a.stl'/></geometry></" + kind + ">";
      const RobotDescription robot = parseRobotDescription(robotWith("<link name='a'>" + element + "</link>"));
      const LinkDescription& link = robot.links.at(0);
      const GeometryElement& read = (kind == "visual" ? link.visuals : link.collisions).at(0);
      EXPECT_NE(read.fault.find("1000 km away from its link's frame; correct its <origin>"), std::string::npos) << read.fault;
    }
  }
  EXPECT_NO_THROW(
      parseRobotDescription(robotWith("<link name='a'/><link name='b'/>" + joint("j", "fixed", "a", "b", "<origin xyz='9e5 0 0'/>"))));
}

// FCL ends the program over such places, too.
TEST(ParseDescription, NoLinkRestsAThousandKilometresAway) {
  const auto load = [](const std::string& limits, const std::string& mimic) {
    const std::string limit = "<limit effort='1' velocity='1' " + limits + "/>";
    const std::string text = robotWith("<link name='a'/><link name='b'/><link name='c'/>" + joint("j", "prismatic", "a", "b", limit) +
                                       joint("k", "revolute", "b", "c", limit + mimic));
    return [text] { parseRobotDescription(text); };
  };
  expectError(ErrorCode::kNotARobot, {"joint 'j'", "link 'b'", "1000 km", "<limit>"}, load("lower='1e308' upper='1e308'", ""));
  expectError(ErrorCode::kNotARobot, {"joint 'j'", "link 'b'", "1000 km"}, load("lower='-3e6' upper='-2e6'", ""));
  expectError(ErrorCode::kNotARobot, {"joint 'k'", "link 'c'", "<mimic>"},
              load("lower='2' upper='3'", "<mimic joint='j' multiplier='1e308'/>"));
  EXPECT_NO_THROW(load("lower='-1e308' upper='1e308'", "")()) << "at rest it is at zero";
}

}  // namespace
}  // namespace collision_hulls
