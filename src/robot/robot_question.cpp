// What urdfdom and tinyxml2 make of a description comes from a process that hostile bytes may have taken over. What the rest of the library
// relies on is checked here: kinds, names, numbers, and that links and joints form a tree.
#include "robot/robot_question.h"

#include <cmath>
#include <unordered_set>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "robot/element_bytes.h"
#include "robot/far_away.h"
#include "sandbox/file_reader.h"

namespace collision_hulls {

// Structured bindings name every member, so a new member does not compile until it travels, too.

template <typename Archive>
void fields(Archive& archive, LinkDescription& link) {
  auto& [name, visuals, collisions, pose, parent] = link;
  archive(name, visuals, collisions, pose, parent);
}

template <typename Archive>
void fields(Archive& archive, JointDescription& joint) {
  auto& [name, kind, parent, child, origin, axis, lower, upper, mimic, mimic_multiplier, mimic_offset] = joint;
  archive(name, kind, parent, child, origin, axis, lower, upper, mimic, mimic_multiplier, mimic_offset);
}

template <typename Archive>
void fields(Archive& archive, RobotDescription& robot) {
  auto& [name, text, path, links, joints, notes, xacro_arguments] = robot;  // xacro was called here
  archive(name, links, joints, notes);
}

namespace {

void expectElements(const LinkDescription& link) {
  for (const auto* const elements : {&link.visuals, &link.collisions}) {
    for (const GeometryElement& element : *elements) {
      if (element.kind < GeometryElement::Kind::kMesh || element.kind > GeometryElement::Kind::kNone)
        throw ByteFault("a geometry is of no known kind");
      if (element.fault.empty() && isFarAway(element.origin)) throw ByteFault("a geometry is too far away");
    }
  }
}

void expectJoint(const JointDescription& joint) {
  if (joint.kind < JointDescription::Kind::kFixed || joint.kind > JointDescription::Kind::kPlanar)
    throw ByteFault("a joint is of no known kind");
  if (isFarAway(joint.origin)) throw ByteFault("a joint is too far away");
  if (!joint.axis.allFinite() || !std::isfinite(joint.lower) || !std::isfinite(joint.upper) || joint.lower > joint.upper)
    throw ByteFault("an axis is not finite, or limits are crossed");
}

/// Each joint leads from the root, or from a link that an earlier joint leads to, to another link.
void expectTree(const RobotDescription& robot) {
  std::unordered_set<std::string> links, reached;
  for (const LinkDescription& link : robot.links) {
    if (!links.insert(link.name).second) throw ByteFault("two links have the same name");
    if (link.parent.empty()) reached.insert(link.name);
    if (isFarAway(link.pose)) throw ByteFault("a link is too far away");
    expectElements(link);
  }
  if (reached.size() != 1) throw ByteFault("it has no root, or several");
  for (const JointDescription& joint : robot.joints) {
    expectJoint(joint);
    if (reached.count(joint.parent) == 0 || links.count(joint.child) == 0 || !reached.insert(joint.child).second)
      throw ByteFault("its joints form no tree");
  }
}

}  // namespace

RobotDescription robotIn(const std::string& answer) {
  RobotDescription robot;
  fromBytes(answer, robot);
  expectTree(robot);
  return robot;
}

std::string descriptionLabel(const std::string& path) {
  if (path.empty()) return "robot description";
  return "'" + path + "'" + (lowerExtension(path) == ".xacro" ? " as xacro expands it" : "");
}

std::string answerRobotQuestion(const Question& question, const RobotDecoder& decode) {
  auto kind = Reading::kRobot;
  std::string path;
  fromBytes(question.head, kind, path);
  return toBytes(decode(question.body, path));
}

RobotDescription parseRobotDescription(const std::string& urdf_text, const std::string& path, const RunControl& control) {
  const std::string label = descriptionLabel(path);
  const std::string answer = askAboutText(toBytes(Reading::kRobot, path), urdf_text, label, control);
  RobotDescription robot = madeOfAnswer(label, "replace the description", [&] { return robotIn(answer); });
  robot.text = urdf_text;
  robot.path = path;
  return robot;
}

}  // namespace collision_hulls
