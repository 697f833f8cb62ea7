// What urdfdom says of one element of a link.
#pragma once

#include <string>

namespace tinyxml2 {
class XMLElement;
}

namespace collision_hulls {

/// Why urdfdom cannot read this <inertial>, <visual> or <collision> in a link of its own; empty if it can.
std::string complaintAbout(const tinyxml2::XMLElement& element, const std::string& link);

}  // namespace collision_hulls
