// Elements of a URDF as they stand in the document, and what urdfdom makes of them.
#pragma once

#include <cstddef>
#include <string>

#include "decode/urdf/urdf_model.h"

namespace tinyxml2 {
class XMLElement;
}

namespace collision_hulls {

/// How many children of this name an element has.
std::size_t countChildren(const tinyxml2::XMLElement& element, const char* name);

/// What the <geometry> of a <visual> or <collision> holds; null if that is nothing.
const tinyxml2::XMLElement* shapeOf(const tinyxml2::XMLElement& element);

/// As readUrdfModel() for the text of <robot>.
UrdfModel readUrdfModel(const tinyxml2::XMLElement& robot);

/// Why urdfdom cannot read this <inertial>, <visual> or <collision> in a link of its own; empty if it can.
std::string complaintAbout(const tinyxml2::XMLElement& element, const std::string& link);

}  // namespace collision_hulls
