#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

CollisionElement mesh(const std::string& name, const std::string& uri) {
  CollisionElement element;
  element.name = name;
  element.geometry.uri = uri;
  return element;
}

using Links = std::map<std::string, LinkCollisions>;

std::string rewritten(const std::string& text, const Links& links) {
  return rewriteCollisions(parseRobotDescription(text), links);
}

// Checks what holds for every rewriting, too.
void expectRewritten(const std::string& text, const Links& links, const std::string& expected) {
  const std::string result = rewritten(text, links);
  EXPECT_EQ(result, expected);
  EXPECT_EQ(withoutCollisions(result), withoutCollisions(text));
}

TEST(WithoutCollisions, IsTheRule) {
  EXPECT_EQ(withoutCollisions("a \n <collision>x</collision> b <collision y='1'/>c <collisions/>"), "a bc <collisions/>");
}

TEST(RewriteCollisions, NothingAskedNothingChanged) {
  const std::string text = "<robot name='r'><link name='a'><collision><geometry><box size='1 1 1'/></geometry></collision></link></robot>";
  expectRewritten(text, {}, text);
}

TEST(RewriteCollisions, MovedMeshesOfLinksThatStay) {
  const std::string link =
      "<link name='a'><visual><geometry><mesh filename='x.stl'/></geometry></visual><collision name='c'><!-- mesh -->"
      "<origin xyz='0 0 1'/><geometry><sphere radius='1'/></geometry></collision>";
  const std::string before =
      "<robot name='r'>" + link + "<collision><geometry><mesh scale='2 2 2' filename = 'x.stl' /></geometry></collision></link></robot>";
  const std::string after = "<robot name='r'>" + link +
                            "<collision><geometry><mesh scale='2 2 2' filename = 'a&amp;b.stl' /></geometry></collision></link></robot>";
  EXPECT_EQ(rewriteCollisions(parseRobotDescription(before), {}, {{"x.stl", "a&b.stl"}, {"y.stl", "z.stl"}}), after);
  const std::string other = rewriteCollisions(parseRobotDescription(before), {{"a", {{mesh("", "x.stl")}, true}}}, {{"x.stl", "y.stl"}});
  EXPECT_EQ(other.find("y.stl"), std::string::npos) << "new elements are as given";
}

// An element that cannot be understood stays as it is, beside one that names the same mesh.
TEST(RewriteCollisions, MovedMeshesOfElementsWithAFault) {
  const std::string faulty =
      "<robot name='r'><link name='a'><collision><origin xyz='a b c'/><geometry><mesh filename='x.stl'/></geometry>"
      "</collision><collision><geometry><mesh filename='";
  const std::string end = "'/></geometry></collision></link></robot>";
  EXPECT_EQ(rewriteCollisions(parseRobotDescription(faulty + "x.stl" + end), {}, {{"x.stl", "y.stl"}}), faulty + "y.stl" + end);
}

TEST(RewriteCollisions, UnknownLink) {
  expectError(ErrorCode::kBadOption, {"no link 'b'"}, [] { rewritten("<robot name='r'><link name='a'/></robot>", {{"b", {}}}); });
}

TEST(RewriteCollisions, TextOfAnotherRobot) {
  RobotDescription robot = parseRobotDescription("<robot name='r'><link name='a'/></robot>");
  robot.links.clear();
  expectError(ErrorCode::kInternal, {"belong together"}, [&] { rewriteCollisions(robot, {}); });
}

const char kArm[] = R"(<?xml version="1.0"?>
<!-- <robot><link name="a"><collision/></link></robot> -->
<robot name="r">
  <link name="a">
    <!-- <collision><geometry><box size="1 1 1"/></geometry></collision> -->
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <collision name="shell">
      <origin rpy="0 0 1.57"   xyz="0.10 0 0"/>
      <geometry><mesh filename="a.stl"/></geometry>
    </collision>   <!-- kept -->
    <visual name="seen">
      <geometry><mesh filename="a.dae"/></geometry>
    </visual>
    <collision>
      <geometry>
        <cylinder radius="1" length="2"/>
      </geometry>
    </collision>
    <sensor><collision>contact</collision></sensor>
  </link>
  <gazebo reference="a"><collision name="x"/></gazebo>
  <x:link name="a" xmlns:x="urn:x"><collision/></x:link>
</robot>
)";

std::string replacedOnce(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

const char kShell[] = R"(
    <collision name="shell">
      <origin rpy="0 0 1.57"   xyz="0.10 0 0"/>
      <geometry><mesh filename="a.stl"/></geometry>
    </collision>)";

const char kCylinder[] = R"(
    <collision>
      <geometry>
        <cylinder radius="1" length="2"/>
      </geometry>
    </collision>)";

TEST(RewriteCollisions, ReplacesInPlaceAndKeepsPrimitives) {
  CollisionElement first = mesh("a_0_0", "package://p/a&b.stl"), second = mesh("a_0_1", "x.stl");
  first.geometry.origin = parseRobotDescription(kArm).links[0].collisions[0].origin;
  second.geometry.scale = {1, -0.5, 1e-3};
  expectRewritten(kArm, {{"a", {{first, second}, true}}}, replacedOnce(kArm, kShell, R"(
    <collision name="a_0_0">
      <origin rpy="0 0 1.57"   xyz="0.10 0 0"/>
      <geometry>
        <mesh filename="package://p/a&amp;b.stl"/>
      </geometry>
    </collision>
    <collision name="a_0_1">
      <geometry>
        <mesh filename="x.stl" scale="1 -0.5 0.001"/>
      </geometry>
    </collision>)"));
}

// What one element has, thousands of new ones would repeat.
TEST(RewriteCollisions, LongIndentationsAndOriginsAreNotRepeated) {
  const std::string blanks(5000, ' '), junk(5000, 'j');
  const std::string text = "<robot name=\"r\">\n<link name=\"a\">\n" + blanks + "<collision><origin xyz=\"1 0 0\" junk=\"" + junk +
                           "\"/><geometry><mesh filename=\"a.stl\"/></geometry></collision>\n</link>\n</robot>";
  CollisionElement hull = mesh("a_0", "x.stl");
  hull.geometry.origin = parseRobotDescription(text).links[0].collisions[0].origin;
  const std::string result = rewritten(text, {{"a", {{hull, hull, hull}, true}}});
  EXPECT_LT(result.size(), 6000u);
  EXPECT_EQ(result.find("junk"), std::string::npos);
  EXPECT_EQ(parseRobotDescription(result).links[0].collisions[2].origin.translation().x(), 1);
}

TEST(RewriteCollisions, ReplacesAll) {
  const std::string without = replacedOnce(kArm, kCylinder, "");
  expectRewritten(kArm, {{"a", {{mesh("n", "n.stl")}, false}}}, replacedOnce(without, kShell, R"(
    <collision name="n">
      <geometry>
        <mesh filename="n.stl"/>
      </geometry>
    </collision>)"));
}

TEST(RewriteCollisions, RemovesAll) {
  expectRewritten(kArm, {{"a", {}}}, replacedOnce(replacedOnce(kArm, kCylinder, ""), kShell, ""));
}

TEST(RewriteCollisions, WritesPrimitives) {
  CollisionElement box, sphere, cylinder;
  box.geometry.kind = GeometryElement::Kind::kBox;
  box.geometry.size = {1, 0.2, 3};
  sphere.geometry.kind = GeometryElement::Kind::kSphere;
  sphere.geometry.size.x() = 0.25;
  cylinder.geometry.kind = GeometryElement::Kind::kCylinder;
  cylinder.geometry.size = {0.5, 2, 0};
  expectRewritten("<robot name='r'><link name='a'><collision><geometry><mesh filename='x'/></geometry></collision></link></robot>",
                  {{"a", {{box, sphere, cylinder}, false}}},
                  "<robot name='r'><link name='a'>"
                  "<collision><geometry><box size=\"1 0.2 3\"/></geometry></collision>"
                  "<collision><geometry><sphere radius=\"0.25\"/></geometry></collision>"
                  "<collision><geometry><cylinder radius=\"0.5\" length=\"2\"/></geometry></collision></link></robot>");
}

TEST(RewriteCollisions, AddsAfterTheLastVisual) {
  const std::string head = "<robot name='r'>\r\n\t<link name='a'>\r\n\t\t<visual><geometry><sphere radius='1'/></geometry></visual>";
  const std::string tail =
      "\r\n\t\t<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>\r\n\t</link></robot>";
  expectRewritten(head + tail, {{"a", {{mesh("n", "n.stl")}, true}}},
                  head +
                      "\r\n\t\t<collision name=\"n\">\r\n\t\t\t<geometry>\r\n\t\t\t\t<mesh filename=\"n.stl\"/>\r\n\t\t\t</geometry>"
                      "\r\n\t\t</collision>" +
                      tail);
}

TEST(RewriteCollisions, AddsFirstInALinkWithoutVisual) {
  expectRewritten(
      "<robot name='r'>\n <link name='a'>\n   <!-- c -->\n   <contact/>\n </link></robot>", {{"a", {{mesh("", "n.stl")}, true}}},
      "<robot name='r'>\n <link name='a'>\n   <collision>\n     <geometry>\n       <mesh filename=\"n.stl\"/>\n     </geometry>\n"
      "   </collision>\n   <!-- c -->\n   <contact/>\n </link></robot>");
}

TEST(RewriteCollisions, AddsToAnEmptyLink) {
  expectRewritten("<robot name='r'>\n  <link name='a'></link></robot>", {{"a", {{mesh("", "n.stl")}, true}}},
                  "<robot name='r'>\n  <link name='a'>\n    <collision>\n      <geometry>\n        <mesh filename=\"n.stl\"/>\n"
                  "      </geometry>\n    </collision></link></robot>");
}

TEST(RewriteCollisions, OpensASelfClosingLinkOnlyToAddToIt) {
  const std::string text = "<robot name='r'>\n  <link name='a/>' />\n</robot>";
  EXPECT_EQ(rewritten(text, {{"a/>", {}}}), text);
  EXPECT_EQ(rewritten(text, {{"a/>", {{mesh("", "n.stl")}, true}}}),
            "<robot name='r'>\n  <link name='a/>'>\n    <collision>\n      <geometry>\n        <mesh filename=\"n.stl\"/>\n"
            "      </geometry>\n    </collision>\n  </link>\n</robot>");
}

TEST(RewriteCollisions, NamesAreUnique) {
  const std::string result =
      rewritten(kArm, {{"a", {{mesh("seen", "1"), mesh("shell", "2"), mesh("shell", "3"), mesh("seen", "4")}, true}}});
  const RobotDescription robot = parseRobotDescription(result);
  std::vector<std::string> names;
  for (const GeometryElement& collision : robot.links[0].collisions) names.push_back(collision.name);
  EXPECT_EQ(names, (std::vector<std::string>{"seen_2", "shell", "shell_2", "seen_3", ""}));
}

TEST(RewriteCollisions, NamesOfOtherLinksAndPrimitivesCount) {
  const std::string box = "<geometry><box size='1 1 1'/></geometry>";
  const std::string text = "<robot name='r'><link name='a'><collision name='p'>" + box +
                           "</collision></link><link name='b'><collision name='q'>" + box +
                           "</collision></link><joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>";
  const RobotDescription robot = parseRobotDescription(rewritten(text, {{"a", {{mesh("p", "1"), mesh("q", "2")}, true}}}));
  std::vector<std::string> names;
  for (const GeometryElement& collision : robot.links[0].collisions) names.push_back(collision.name);
  EXPECT_EQ(names, (std::vector<std::string>{"p_2", "q_2", "p"}));
}

TEST(RewriteCollisions, EscapesWhatAttributesCannotHold) {
  const std::string odd = "<&>\"'\t\n\xC3\xA9%20";
  const RobotDescription robot =
      parseRobotDescription(rewritten("<robot name='r'><link name='a'/></robot>", {{"a", {{mesh(odd, odd)}, true}}}));
  EXPECT_EQ(robot.links[0].collisions.at(0).name, odd);
  EXPECT_EQ(robot.links[0].collisions[0].uri, odd);
}

TEST(RewriteCollisions, RefusesWhatCannotBeWritten) {
  const std::string text = "<robot name='r'><link name='a'/></robot>";
  const auto refuses = [&](const CollisionElement& element, const std::string& part) {
    expectError(ErrorCode::kBadOption, {"link 'a'", part}, [&] { rewritten(text, {{"a", {{element}, true}}}); });
  };
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    CollisionElement moved = mesh("", "n.stl"), scaled = moved;
    moved.geometry.origin.translation().y() = wrong;
    scaled.geometry.scale.x() = wrong;
    refuses(moved, "must be finite");
    refuses(scaled, "must be finite");
  }
  CollisionElement flat = mesh("", "n.stl"), ball;
  flat.geometry.scale.z() = 0;
  refuses(flat, "a scale is 0");
  ball.geometry.kind = GeometryElement::Kind::kSphere;
  refuses(ball, "a size is not above 0");
}

TEST(RewriteCollisions, AnOriginWithoutATextIsWrittenInNumbers) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-3, 3);
  for (int i = 0; i < 50; ++i) {
    CollisionElement element = mesh("", "n.stl");
    const double pitch = i % 3 == 0 ? M_PI / 2 : number(random) / 2;
    element.geometry.origin = Eigen::Translation3d(number(random), number(random) * 1e-9, number(random)) *
                              Eigen::AngleAxisd(number(random), Eigen::Vector3d::UnitZ()) *
                              Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                              Eigen::AngleAxisd(number(random), Eigen::Vector3d::UnitX());
    const RobotDescription robot = parseRobotDescription(rewritten("<robot name='r'><link name='a'/></robot>", {{"a", {{element}, true}}}));
    const Eigen::Isometry3d& read = robot.links[0].collisions.at(0).origin;
    EXPECT_EQ(read.translation(), element.geometry.origin.translation());
    EXPECT_LT((read.linear() - element.geometry.origin.linear()).cwiseAbs().maxCoeff(), 1e-14) << "sample " << i;
  }
}

// Random descriptions out of awkward pieces, against the rule that an outside checker uses.
std::string randomDescription(std::mt19937_64& random, int links) {
  const std::vector<std::string> pieces{"<!-- </link> <visual/> -->",
                                        "<![CDATA[</link>]]>",
                                        "<?p </link> ?>",
                                        "text ",
                                        "<contact a='>' b=\"/>\"/>",
                                        "<visual><geometry><mesh filename='v.dae'/></geometry></visual>",
                                        "<visual>\n<origin xyz='1 0 0'/><geometry><box size='1 1 1'/></geometry></visual\n>",
                                        "<collision><geometry><mesh filename='c.stl'/></geometry></collision>",
                                        "<collision name='>'><geometry><!-- > --><sphere radius=\"1\"/></geometry></collision >",
                                        "<collision\n><geometry ><mesh filename=\"d.stl\" /></geometry></collision>"};
  const std::vector<std::string> spaces{"", " ", "\n  ", "\r\n\t", "\n\n"};
  const auto any = [&random](const std::vector<std::string>& from) { return from[random() % from.size()]; };
  std::string text = "<?xml version='1.0'?>" + any(spaces) + "<robot name='r'>";
  for (int i = 0; i < links; ++i) {
    text += any(spaces) + "<link name='l" + std::to_string(i) + "'>";
    for (std::size_t n = random() % 6; n > 0; --n) text += any(spaces) + any(pieces);
    text += any(spaces) + "</link>";
    if (i > 0)
      text += "<joint name='j" + std::to_string(i) + "' type='fixed'><parent link='l0'/><child link='l" + std::to_string(i) + "'/></joint>";
  }
  return text + any(spaces) + "</robot>" + any(spaces);
}

TEST(RewriteCollisions, RandomDescriptionsDifferInCollisionsAlone) {
  std::mt19937_64 random(4);
  for (int sample = 0; sample < 300; ++sample) {
    const std::string text = randomDescription(random, 4);
    Links links;
    for (int i = 0; i < 4; ++i) {
      LinkCollisions& link = links["l" + std::to_string(i)];
      for (std::size_t n = random() % 3; n > 0; --n) link.elements.push_back(mesh("hull", "h.stl"));
      link.keep_primitives = random() % 2 == 0;
    }
    // The rule takes "</collision>" for the end tag, so a "</collision >" has to go, too.
    const std::string plain = [](std::string from) {
      for (std::size_t at; (at = from.find("</collision >")) != std::string::npos;) from.erase(at + 11, 1);
      return from;
    }(text);
    EXPECT_EQ(withoutCollisions(rewritten(plain, links)), withoutCollisions(plain)) << "sample " << sample << ": " << plain;
    EXPECT_NO_THROW(rewritten(text, links)) << "sample " << sample << ": " << text;
  }
}

TEST(RewriteCollisions, AnyTruncationIsRefusedOrRewritten) {
  const std::string text = kArm;
  for (std::size_t size = 0; size < text.size(); ++size) {
    try {
      rewritten(text.substr(0, size), {{"a", {{mesh("n", "n.stl")}, true}}});
      EXPECT_GE(size, text.find("</robot>\n", text.find("x:link")) + 8) << size;
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == ErrorCode::kNotXml) << size << error.what();
    }
  }
}

}  // namespace
}  // namespace collision_hulls
