// urdfdom names the joint or link in brackets or quotes, and says neither its line nor what it should have been.
#include "decode/urdf/refusal.h"

#include <tinyxml2.h>

#include <algorithm>
#include <unordered_set>

namespace collision_hulls {
namespace {

using Names = std::unordered_set<std::string>;

struct Remedy {
  const char* complaint;  ///< a part of it
  const char* remedy;
};

constexpr Remedy kRemedies[] = {
    {"does not specify limits", "give it <limit lower=\"...\" upper=\"...\" effort=\"...\" velocity=\"...\"/>, in radians or metres"},
    {"without limits", "give it <limit lower=\"...\" upper=\"...\" effort=\"...\" velocity=\"...\"/>, in metres"},
    {"joint limit: no effort", "add effort=\"...\" to its <limit>"},
    {"joint limit: no velocity", "add velocity=\"...\" to its <limit>"},
    {"joint safety: no k_velocity", "add k_velocity=\"...\" to its <safety_controller>"},
    {"has no known type", "use revolute, continuous, prismatic, fixed, floating or planar"},
    {"has no type", "add type=\"...\": revolute, continuous, prismatic, fixed, floating or planar"},
    {"missing a parent and/or child", "give it <parent link=\"...\"/> and <child link=\"...\"/>"},
    {"Two root links", "connect them with a joint"},
    {"is not unique", "rename one of them"},
    {"No name given for the robot", "write <robot name=\"...\">"},
    {"unnamed joint", "give each <joint> a name=\"...\""},
    {"[$", "$(...) and ${...} are for xacro: write the value, or let xacro expand the file"},
    {"is not a valid", "write a decimal number"},
    {"Unable to parse component", "write decimal numbers with spaces between them"},
    {"expected while parsing vector", "write as many numbers as it expects, with spaces between them"},
    {"no mimic joint specified", "add joint=\"...\" to its <mimic>"},
    {"not found", "correct the name, or add the link"},
};

std::string remedyFor(const std::string& complaints) {
  for (const Remedy& each : kRemedies)
    if (complaints.find(each.complaint) != std::string::npos) return each.remedy;
  return "correct it";
}

// What stands in brackets or quotes behind each `word`, and its last letters are enough.
Names namesAfter(const std::string& word, const std::string& complaints) {
  Names names;
  for (std::size_t at = 0; (at = complaints.find(word + " ", at)) != std::string::npos;) {
    at = std::min(complaints.find_first_not_of(' ', at + word.size()), complaints.size());
    const char opening = at < complaints.size() ? complaints[at] : ' ';
    if (opening != '[' && opening != '\'') continue;
    const std::size_t begin = at + 1, end = complaints.find(opening == '[' ? ']' : '\'', begin);
    if (end != std::string::npos) names.insert(complaints.substr(begin, end - begin));
  }
  return names;
}

const tinyxml2::XMLElement* lastNamed(const tinyxml2::XMLElement& robot, const char* kind, const Names& names) {
  for (const auto* element = robot.LastChildElement(kind); element; element = element->PreviousSiblingElement(kind)) {
    const char* name = element->Attribute("name");
    if (name && names.count(name) > 0) return element;
  }
  return nullptr;
}

}  // namespace

Refusal refusalOf(const tinyxml2::XMLElement& robot, const std::string& complaints) {
  const tinyxml2::XMLElement* element = lastNamed(robot, "joint", namesAfter("oint", complaints));
  if (!element) element = lastNamed(robot, "link", namesAfter("ink", complaints));
  if (!element) element = lastNamed(robot, "material", namesAfter("aterial", complaints));
  if (!element) element = lastNamed(robot, "link", namesAfter("and", complaints));  // "Two root links found: [a] and [b]"
  return {(element ? element : &robot)->GetLineNum(), remedyFor(complaints)};
}

}  // namespace collision_hulls
