// A robot description from text: elements by tinyxml2, meaning by urdfdom.
#include "decode/urdf/decode_robot.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <unordered_map>

#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "decode/urdf/geometry_stand_ins.h"
#include "decode/urdf/joint_graph.h"
#include "decode/urdf/refusal.h"
#include "decode/urdf/urdf_elements.h"
#include "decode/urdf/urdfdom_losses.h"
#include "decode/xml_source.h"
#include "robot/far_away.h"
#include "robot/robot_question.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostElements = 100'000;
constexpr std::size_t kLongestName = 1000;  // [bytes] of the robot, a link, a joint

// "<xacro:include> in line 7": the first of xacro's elements; empty if there is none.
std::string xacroElement(const XmlSource& subject, const tinyxml2::XMLElement& root) {
  for (const auto* child = root.FirstChildElement(); child; child = child->NextSiblingElement()) {
    const std::string name = child->Name();
    if (name.rfind("xacro:", 0) == 0) return "<" + name + "> in line " + std::to_string(subject.lineFromRoot(child->GetLineNum()));
  }
  return "";
}

std::string xacroHint(const XmlSource& subject, const tinyxml2::XMLElement& root) {
  const std::string found = xacroElement(subject, root);
  return found.empty() ? "" : "; " + found + " shows that this is a xacro file: rename it to .xacro, or expand it first";
}

// Expanded descriptions often have some left, and urdfdom ignores them.
std::vector<std::string> notesOn(const XmlSource& subject, const tinyxml2::XMLElement& root) {
  const std::string found = xacroElement(subject, root);
  if (found.empty()) return {};
  return {subject.label + ": " + found +
          " is a xacro element, which a plain URDF cannot expand; if the robot needs it, rename the file to .xacro, " +
          "or expand it first"};
}

void checkIsRobot(const XmlSource& subject, const tinyxml2::XMLElement& root) {
  const std::string name = root.Name();
  const std::size_t line = subject.lineFromRoot(root.GetLineNum());
  if (name != "robot") subject.failAt(ErrorCode::kNotARobot, line, "the root element is <" + name + ">; a URDF's is <robot>");
  if (!root.FirstChildElement("link")) {
    subject.failAt(ErrorCode::kNoLinks, line, "<robot> has no <link>; a robot has at least one" + xacroHint(subject, root));
  }
}

void checkName(const XmlSource& subject, const tinyxml2::XMLElement& element) {
  const char* name = element.Attribute("name");
  if (!name) return;
  if (const char* c = std::find_if(name, name + std::strlen(name), isTerminalControl); *c != 0)
    subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(element.GetLineNum()),
                   std::string("the name of this <") + element.Name() + "> holds a control character; remove it");
  if (std::strlen(name) <= kLongestName) return;
  subject.failAt(
      ErrorCode::kNotARobot, subject.lineFromRoot(element.GetLineNum()),
      std::string("the name of this <") + element.Name() + "> is longer than " + std::to_string(kLongestName) + " bytes; shorten it");
}

// urdfdom accepts links without a name. Messages repeat names.
void checkNames(const XmlSource& subject, const tinyxml2::XMLElement& root) {
  for (const auto* link = root.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    const char* name = link->Attribute("name");
    if (!name || !*name) subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(link->GetLineNum()), "a <link> has no name");
    checkName(subject, *link);
  }
  for (const auto* joint = root.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) checkName(subject, *joint);
  checkName(subject, root);
}

// Whether urdfdom kept all elements of all links.
bool isWhole(const tinyxml2::XMLElement& root, const UrdfModel& model) {
  std::size_t there = 0, taken = 0;
  for (const auto* link = root.FirstChildElement("link"); link; link = link->NextSiblingElement("link"))
    there += countChildren(*link, "visual") + countChildren(*link, "collision");
  for (const LinkDescription& link : model.links) taken += link.visuals.size() + link.collisions.size();
  return taken == there;
}

// Leaves out the elements that urdfdom cannot read.
UrdfModel readWhatCanBeRead(const tinyxml2::XMLElement& root, GeometryStandIns& stand_ins) {
  try {
    UrdfModel model = readUrdfModel(root);
    if (isWhole(root, model)) return model;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // comes again below unless an element was the reason
  }
  stand_ins.takeOutUnreadable();
  return readUrdfModel(root);
}

void checkGraph(const XmlSource& subject, const tinyxml2::XMLElement& root) {
  try {
    checkJointGraph(root);
  } catch (const JointGraphError& error) {
    subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(error.line()), error.what());
  }
}

UrdfModel loadModel(const XmlSource& subject, const tinyxml2::XMLElement& root, GeometryStandIns& stand_ins) {
  try {
    return readWhatCanBeRead(root, stand_ins);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    const Refusal refusal = refusalOf(root, error.what());
    const std::string hint = xacroHint(subject, root);
    subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(refusal.line),
                   std::string("urdfdom refuses it: ") + error.what() + (hint.empty() ? "; " + refusal.remedy : hint));
  }
}

void checkNothingLost(const XmlSource& subject, const tinyxml2::XMLElement& element, const LinkDescription& link,
                      const std::string& complaints) {
  if (link.visuals.size() == countChildren(element, "visual") && link.collisions.size() == countChildren(element, "collision")) return;
  subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(element.GetLineNum()),
                 "urdfdom drops geometry of link '" + link.name + "' (" + complaints + "); correct the element that it names");
}

// urdfdom's links, which come by name, in the order of the document.
std::vector<LinkDescription> inDocumentOrder(const XmlSource& subject, const tinyxml2::XMLElement& root, UrdfModel& model,
                                             const GeometryStandIns& stand_ins) {
  std::unordered_map<std::string, LinkDescription*> by_name;
  for (LinkDescription& link : model.links) by_name[link.name] = &link;
  std::vector<LinkDescription> links;
  for (const auto* element = root.FirstChildElement("link"); element; element = element->NextSiblingElement("link")) {
    const std::string name = element->Attribute("name");
    const auto found = by_name.find(name);
    if (found == by_name.end()) {
      subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(element->GetLineNum()), "urdfdom does not know link '" + name + "'");
    }
    checkNothingLost(subject, *element, *found->second, model.complaints);
    stand_ins.insertInto(*found->second);
    links.push_back(std::move(*found->second));
    by_name.erase(found);
  }
  return links;
}

// Messages, tables and reports repeat URIs and faults: what is too long for a path is an element's fault, and not repeated as a whole.
void shortenTexts(std::vector<LinkDescription>& links) {
  for (LinkDescription& link : links) {
    for (auto* const elements : {&link.visuals, &link.collisions}) {
      for (GeometryElement& element : *elements) {
        element.fault = shortened(element.fault, 2 * kLongestName);
        if (element.uri.size() <= kLongestUri) continue;
        if (element.fault.empty())
          element.fault = "a file name of " + std::to_string(element.uri.size()) + " bytes; a path has " + std::to_string(kLongestUri) +
                          " at most: correct it";
        element.uri = shown(element.uri);
      }
    }
  }
}

// Coordinates of such a size overflow in products, of which FCL and others do not expect it.
void checkOrigins(const XmlSource& subject, const std::vector<JointDescription>& joints, std::vector<LinkDescription>& links) {
  for (const JointDescription& joint : joints)
    if (isFarAway(joint.origin))
      subject.fail(ErrorCode::kNotARobot, "joint '" + joint.name + "' has an origin more than 1000 km away; correct its <origin>");
  for (LinkDescription& link : links)
    for (auto* const elements : {&link.visuals, &link.collisions})
      for (GeometryElement& element : *elements)
        if (element.fault.empty() && isFarAway(element.origin))
          element.fault = "it is more than 1000 km away from its link's frame; correct its <origin>";
}

// A limit far from zero does it, and so do the numbers of a <mimic>.
void checkRestPoses(const XmlSource& subject, const std::vector<JointDescription>& joints, const std::vector<LinkDescription>& links) {
  std::unordered_map<std::string, const LinkDescription*> by_name;
  for (const LinkDescription& link : links) by_name[link.name] = &link;
  for (const JointDescription& joint : joints)
    if (isFarAway(by_name.at(joint.child)->pose))
      subject.fail(ErrorCode::kNotARobot, "joint '" + joint.name + "' leaves link '" + joint.child +
                                              "' no place within 1000 km of the root link when all joints are at rest; correct its " +
                                              "<origin>, <limit> or <mimic>");
}

void checkAxes(const XmlSource& subject, const std::vector<JointDescription>& joints) {
  for (const JointDescription& joint : joints) {
    if (joint.kind == JointDescription::Kind::kFixed || joint.kind == JointDescription::Kind::kFloating || joint.axis.norm() > 0) continue;
    subject.fail(ErrorCode::kNotARobot, "joint '" + joint.name + "' has the axis 0 0 0; give it a direction");
  }
}

}  // namespace

RobotDescription decodeRobot(const std::string& urdf_text, const std::string& path) {
  XmlSource subject{urdf_text, descriptionLabel(path)};
  tinyxml2::XMLDocument document;
  loadRoot(subject, document);
  if (subject.elements > kMostElements)
    subject.fail(ErrorCode::kTooLarge, "it has " + std::to_string(subject.elements) + " elements, above the limit of " +
                                           std::to_string(kMostElements) +
                                           "; no robot that we know has a tenth of that: give a smaller one");
  tinyxml2::XMLElement& robot = *document.RootElement();
  checkIsRobot(subject, robot);
  checkNames(subject, robot);
  checkGraph(subject, robot);
  const std::vector<std::string> losses = notesOnLosses(subject, robot);
  GeometryStandIns stand_ins(subject, robot);
  stand_ins.takeOutOtherThings();
  UrdfModel model = loadModel(subject, robot, stand_ins);
  checkAxes(subject, model.joints);
  std::vector<LinkDescription> links = inDocumentOrder(subject, robot, model, stand_ins);
  checkOrigins(subject, model.joints, links);
  checkRestPoses(subject, model.joints, links);
  shortenTexts(links);
  std::vector<std::string> notes = notesOn(subject, robot);
  notes.insert(notes.end(), losses.begin(), losses.end());
  notes.insert(notes.end(), stand_ins.notes().begin(), stand_ins.notes().end());
  const std::string name = model.name.empty() ? std::filesystem::path(path).stem().string() : model.name;
  return {name.empty() ? "robot" : name, "", path, std::move(links), std::move(model.joints), std::move(notes)};
}

}  // namespace collision_hulls
