// A robot description from text: structure by the span scanner, attributes by tinyxml2, meaning by urdfdom.
#include <tinyxml2.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/joint_graph.h"
#include "robot/urdf_model.h"
#include "robot/xml_spans.h"

namespace collision_hulls {
namespace {

// The text that is being parsed, and how messages name it.
struct Subject {
  std::string_view text;
  std::string label;
  std::size_t root_offset = 0;  // of the root element; tinyxml2 counts lines from there

  [[noreturn]] void fail(ErrorCode code, const std::string& reason) const { throw Error(code, label + ": " + reason); }
  [[noreturn]] void failAt(ErrorCode code, std::size_t line, const std::string& reason) const {
    throw Error(code, label + ", line " + std::to_string(line) + ": " + reason);
  }
  std::size_t lineFromRoot(int line) const { return lineOf(text, root_offset) + static_cast<std::size_t>(line) - 1; }
};

void checkEncoding(const Subject& subject) {
  const std::string_view mark = subject.text.substr(0, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF") subject.fail(ErrorCode::kNotXml, "the text is UTF-16; save it as UTF-8");
  const std::size_t zero = subject.text.find('\0');
  if (zero != std::string_view::npos) {
    subject.failAt(ErrorCode::kNotXml, lineOf(subject.text, zero), "a zero byte, which XML text never holds");
  }
}

XmlOutline scan(const Subject& subject) {
  try {
    return scanXml(subject.text);
  } catch (const XmlSyntaxError& error) {
    subject.failAt(ErrorCode::kNotXml, lineOf(subject.text, error.offset()), std::string(error.what()) + "; the description has to be XML");
  }
}

// The root alone and without processing instructions, which are legal XML: tinyxml2 ends a document type at its first '>', even
// within an internal subset, and takes every instruction for a misplaced XML declaration. Lines stay what they were.
std::string readableRoot(const Subject& subject, const XmlOutline& outline) {
  std::string text(subject.text.substr(0, outline.elements.front().end));
  for (const XmlSpan& span : outline.instructions) {
    for (std::size_t i = span.begin; i < std::min(span.end, text.size()); ++i) text[i] = text[i] == '\n' ? '\n' : ' ';
  }
  return text.substr(outline.elements.front().begin);
}

void load(const Subject& subject, const std::string& root, tinyxml2::XMLDocument& document) {
  document.Parse(root.data(), root.size());
  if (!document.Error()) return;
  const std::size_t line = subject.lineFromRoot(document.ErrorLineNum());
  if (document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    subject.failAt(ErrorCode::kNotXml, line, "elements nest deeper than " + std::to_string(TINYXML2_MAX_ELEMENT_DEPTH) + " levels");
  }
  subject.failAt(ErrorCode::kNotXml, line, std::string("the XML cannot be read (") + document.ErrorName() + ")");
}

std::string xacroHint(const Subject& subject, const tinyxml2::XMLElement& root) {
  for (const auto* child = root.FirstChildElement(); child; child = child->NextSiblingElement()) {
    const std::string name = child->Name();
    if (name.rfind("xacro:", 0) != 0) continue;
    return "; <" + name + "> in line " + std::to_string(subject.lineFromRoot(child->GetLineNum())) +
           " shows that this is a xacro file: give it the extension .xacro, or expand it first";
  }
  return "";
}

void checkIsRobot(const Subject& subject, const tinyxml2::XMLElement& root) {
  const std::string name = root.Name();
  const std::size_t line = subject.lineFromRoot(root.GetLineNum());
  if (name != "robot") subject.failAt(ErrorCode::kNotARobot, line, "the root element is <" + name + ">; a URDF's is <robot>");
  if (!root.FirstChildElement("link")) {
    subject.failAt(ErrorCode::kNoLinks, line, "<robot> has no <link>; a robot has at least one" + xacroHint(subject, root));
  }
}

// urdfdom lets them pass.
void checkLinksHaveNames(const Subject& subject, const tinyxml2::XMLElement& root) {
  for (const auto* link = root.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    const char* name = link->Attribute("name");
    if (name && *name) continue;
    subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(link->GetLineNum()), "a <link> has no name");
  }
}

UrdfModel loadModel(const Subject& subject, const tinyxml2::XMLElement& root) {
  tinyxml2::XMLPrinter printer(nullptr, true);
  root.Accept(&printer);
  try {
    checkJointGraph(root);
    return readUrdfModel(printer.CStr());
  } catch (const JointGraphError& error) {
    subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(error.line()), error.what());
  } catch (const std::exception& error) {
    subject.fail(ErrorCode::kNotARobot, std::string("urdfdom refuses it: ") + error.what() + xacroHint(subject, root));
  }
}

std::size_t countChildren(const tinyxml2::XMLElement& link, const char* name) {
  std::size_t count = 0;
  for (const auto* child = link.FirstChildElement(name); child; child = child->NextSiblingElement(name)) ++count;
  return count;
}

void checkNothingLost(const Subject& subject, const tinyxml2::XMLElement& element, const LinkDescription& link,
                      const std::string& complaints) {
  if (link.visuals.size() == countChildren(element, "visual") && link.collisions.size() == countChildren(element, "collision")) return;
  subject.failAt(ErrorCode::kNotARobot, subject.lineFromRoot(element.GetLineNum()),
                 "urdfdom drops geometry of link '" + link.name + "' (" + complaints + "); mend the element that it names");
}

// urdfdom's links, which come by name, in the order of the document.
std::vector<LinkDescription> inDocumentOrder(const Subject& subject, const tinyxml2::XMLElement& root, UrdfModel& model) {
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
    links.push_back(std::move(*found->second));
    by_name.erase(found);
  }
  return links;
}

}  // namespace

RobotDescription parseRobotDescription(const std::string& urdf_text, const std::string& path) {
  Subject subject{urdf_text, path.empty() ? "robot description" : "'" + path + "'"};
  checkEncoding(subject);
  const XmlOutline outline = scan(subject);
  subject.root_offset = outline.elements.front().begin;
  tinyxml2::XMLDocument document;
  load(subject, readableRoot(subject, outline), document);
  const tinyxml2::XMLElement& robot = *document.RootElement();
  checkIsRobot(subject, robot);
  checkLinksHaveNames(subject, robot);
  UrdfModel model = loadModel(subject, robot);
  std::vector<LinkDescription> links = inDocumentOrder(subject, robot, model);
  return {model.name, urdf_text, path, std::move(links), std::move(model.joints)};
}

}  // namespace collision_hulls
