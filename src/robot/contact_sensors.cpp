// URDF's own <collision> elements hold elements; those of a sensor hold a name.
#include "robot/contact_sensors.h"

#include <cstddef>
#include <string_view>

#include "base/string_parts.h"
#include "xml/xml_spans.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongest = 3000;  // [bytes]: names of two links, which have a thousand at most, and what is between and behind them

/// What an element without children holds before the first comment.
std::string textOf(const XmlElement& element, const std::string& text) {
  return trimmed(std::string_view(text).substr(element.tag_end, text.find('<', element.tag_end) - element.tag_end), kXmlSpace);
}

}  // namespace

std::set<std::string> unnamedContacts(const std::string& urdf) {
  const std::vector<XmlElement> elements = scanXml(urdf).elements;
  std::set<std::string> names;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const XmlElement& element = elements[i];
    if (element.name != "collision" || element.self_closing || element.subtree_end > i + 1) continue;
    const std::string name = textOf(element, urdf);
    if (!name.empty() && name.size() <= kLongest) names.insert(name);
  }
  for (auto element = elements.begin(); element != elements.end() && !names.empty(); ++element)
    if (const auto value = attributeValue(urdf, *element, "name")) names.erase(urdf.substr(value->begin, value->end - value->begin));
  return names;
}

std::vector<std::string> linksOfCollision(const std::string& name) {
  constexpr std::string_view kCollision = "_collision", kLump = "_fixed_joint_lump__";
  std::vector<std::string> links;
  for (std::size_t at = name.find(kCollision); at != std::string::npos; at = name.find(kCollision, at + 1)) {
    const std::string link = name.substr(0, at);
    links.push_back(link);
    const std::size_t lump = link.rfind(kLump);
    if (lump != std::string::npos) links.push_back(link.substr(lump + kLump.size()));
  }
  return links;
}

}  // namespace collision_hulls
