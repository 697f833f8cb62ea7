// XML as a tree of plain values, for formats that need no more than that.
#include "xml/xml_tree.h"

namespace collision_hulls {

std::string XmlNode::attribute(const std::string& key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? "" : found->second;
}

const XmlNode* XmlNode::child(const std::string& child_name) const {
  for (const XmlNode& node : children) {
    if (node.name == child_name) return &node;
  }
  return nullptr;
}

std::vector<const XmlNode*> XmlNode::childrenNamed(const std::string& child_name) const {
  std::vector<const XmlNode*> result;
  for (const XmlNode& node : children) {
    if (node.name == child_name) result.push_back(&node);
  }
  return result;
}

std::string xmlEscaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&apos;"; break;
      case '\t': result += "&#9;"; break;  // as they stand, readers of attributes take these three for blanks
      case '\n': result += "&#10;"; break;
      case '\r': result += "&#13;"; break;
      default: result += c;
    }
  }
  return result;
}

}  // namespace collision_hulls
