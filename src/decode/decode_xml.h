// From an XML text to its tree, in this process.
#pragma once

#include <string>

#include "xml/xml_tree.h"

namespace collision_hulls {

/// What parseXml() does.
XmlNode decodeXml(const std::string& text, const std::string& label);

}  // namespace collision_hulls
