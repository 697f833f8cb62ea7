#include "robot/robot_question.h"

#include <limits>
#include <tuple>

#include "decode/urdf/decode_robot.h"
#include "geometry/bytes.h"
#include "robot/robot_tests.h"
#include "sandbox/file_reader.h"

namespace collision_hulls {
namespace {

const std::string kRobot = R"(<robot name="r"><link name="a"><visual name="v"><origin xyz="1 2 3" rpy="0.1 0.2 0.3"/><geometry>
<mesh filename="m.stl" scale="1 2 -3"/></geometry></visual><collision><geometry><cylinder radius="1" length="2"/></geometry></collision>
<collision><geometry><capsule/></geometry></collision></link><link name="b"><visual/></link><link name="c"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/><origin xyz="0 0 1" rpy="1 0 0"/>
<limit lower="-1" upper="2" effort="1" velocity="1"/></joint><joint name="k" type="prismatic"><parent link="b"/><child link="c"/>
<limit lower="0" upper="1" effort="1" velocity="1"/><mimic joint="j" multiplier="2" offset="0.5"/></joint></robot>)";

void expectSame(const GeometryElement& a, const GeometryElement& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.uri, b.uri);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.origin.matrix(), b.origin.matrix());
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.fault, b.fault);
}

void expectSame(const LinkDescription& a, const LinkDescription& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.parent, b.parent);
  EXPECT_EQ(a.pose.matrix(), b.pose.matrix());
  ASSERT_EQ(a.visuals.size(), b.visuals.size());
  ASSERT_EQ(a.collisions.size(), b.collisions.size());
  for (std::size_t i = 0; i < a.visuals.size(); ++i) expectSame(a.visuals[i], b.visuals[i]);
  for (std::size_t i = 0; i < a.collisions.size(); ++i) expectSame(a.collisions[i], b.collisions[i]);
}

void expectSame(const JointDescription& a, const JointDescription& b) {
  EXPECT_EQ(std::tie(a.name, a.kind, a.parent, a.child, a.lower, a.upper, a.mimic, a.mimic_multiplier, a.mimic_offset),
            std::tie(b.name, b.kind, b.parent, b.child, b.lower, b.upper, b.mimic, b.mimic_multiplier, b.mimic_offset));
  EXPECT_EQ(a.origin.matrix(), b.origin.matrix());
  EXPECT_EQ(a.axis, b.axis);
}

TEST(RobotQuestion, SameAsInThisProcess) {
  const RobotDescription there = parseRobotDescription(kRobot, "arm.urdf"), here = decodeRobot(kRobot, "arm.urdf");
  EXPECT_EQ(there.name, here.name);
  EXPECT_EQ(there.text, kRobot);
  EXPECT_EQ(there.path, "arm.urdf");
  EXPECT_EQ(there.notes, here.notes);
  EXPECT_EQ(there.notes.size(), 2u);
  ASSERT_EQ(there.links.size(), 3u);
  ASSERT_EQ(there.joints.size(), 2u);
  for (std::size_t i = 0; i < 3; ++i) expectSame(there.links[i], here.links[i]);
  for (std::size_t i = 0; i < 2; ++i) expectSame(there.joints[i], here.joints[i]);
  EXPECT_FALSE(there.links[0].collisions[1].fault.empty());
}

TEST(RobotQuestion, CancelledAtOnce) {
  RunControl control;
  control.cancel();
  expectError(ErrorCode::kCancelled, {}, [&] { parseRobotDescription(kRobot, "", control); });
}

TEST(RobotQuestion, ANameThatIsNoName) {
  expectError(ErrorCode::kNotXml, {"the name of an element is not allowed in XML"}, [] { parseRobotDescription("<!-ameoM/>"); });
}

TEST(RobotQuestion, MoreElementsThanAnyRobotHas) {
  const auto robot = [](int count) {
    std::string text = "<robot name='r'><link name='a'/>";
    for (int i = 0; i < count; ++i) text += "<x/>";
    return text + "</robot>";
  };
  EXPECT_NO_THROW(parseRobotDescription(robot(99'998)));
  expectError(ErrorCode::kTooLarge, {"100001 elements"}, [&] { parseRobotDescription(robot(99'999)); });
}

TEST(RobotQuestion, FileNamesThatNoPathHas) {
  const RobotDescription robot = parseRobotDescription("<robot name='r'><link name='a'><visual><geometry><mesh filename='" +
                                                       std::string(5000, 'u') + "'/></geometry></visual></link></robot>");
  const GeometryElement& element = robot.links.at(0).visuals.at(0);
  EXPECT_LT(element.uri.size(), 300u);
  EXPECT_NE(element.fault.find("5000 bytes"), std::string::npos) << element.fault;
}

/// What a worker answers, with joints a-b and b-c after a change.
template <class Change>
std::string changed(const Change& change) {
  std::string head = toBytes(Reading::kRobot, std::string());
  std::string answer = answerRobotQuestion({head, kRobot, -1}, decodeRobot);
  change(answer);
  return answer;
}

void replaceAll(std::string& bytes, const std::string& old, const std::string& now) {
  for (std::size_t at = bytes.find(old); at != std::string::npos; at = bytes.find(old, at + now.size())) bytes.replace(at, old.size(), now);
}

TEST(RobotQuestion, AnAnswerThatIsNoRobot) {
  const auto link = [](const std::string& name) { return toBytes(name); };
  EXPECT_NO_THROW(robotIn(changed([](std::string&) {})));
  EXPECT_THROW(robotIn(changed([](std::string& bytes) { bytes.pop_back(); })), ByteFault);
  EXPECT_THROW(robotIn(changed([&](std::string& bytes) { replaceAll(bytes, link("c"), link("b")); })), ByteFault);  // twice
  EXPECT_THROW(robotIn(changed([&](std::string& bytes) {                                                            // no root
                 const std::size_t root = bytes.find(link("a"));
                 replaceAll(bytes, link("a"), link("b"));
                 bytes.replace(root, link("a").size(), link("a"));
               })),
               ByteFault);
  EXPECT_THROW(robotIn(changed([](std::string& bytes) { replaceAll(bytes, toBytes(3.0), toBytes(1e300)); })), ByteFault) << "far away";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(robotIn(changed([&](std::string& bytes) { replaceAll(bytes, toBytes(0.5), toBytes(nan)); })), ByteFault) << "a link's pose";
  EXPECT_THROW(robotIn(changed([](std::string& bytes) { replaceAll(bytes, toBytes(-1.0), toBytes(5.0)); })), ByteFault) << "limits crossed";
  EXPECT_THROW(robotIn(""), ByteFault);
}

}  // namespace
}  // namespace collision_hulls
