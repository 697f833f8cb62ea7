// XML as values, for rooms that read other documents than robot descriptions.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// An element. Comments and processing instructions are left out.
struct XmlNode {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< that stands first in it, before any child, without blanks around it
  std::size_t line = 0;
  std::vector<XmlNode> children;

  /// The value of an attribute; empty where it is not there.
  std::string attribute(const std::string& key) const;
  /// The first child of that name; null where there is none.
  const XmlNode* child(const std::string& child_name) const;
  std::vector<const XmlNode*> childrenNamed(const std::string& child_name) const;
};

/// The root element of a document. `label` stands in messages. Entities that a document type defines are not expanded, so that none grow.
/// Parsed in a process of its own (sandbox/file_reader.h). Throws kNotXml with the line; what ReaderProgram::ask() throws.
XmlNode parseXml(const std::string& text, const std::string& label, const RunControl& control = {});

/// Text for an attribute's value or an element's content, with what XML reserves escaped.
std::string xmlEscaped(const std::string& text);

}  // namespace collision_hulls
