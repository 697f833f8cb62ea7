// What urdfdom, and so rviz and MoveIt, does not see of a description.
#pragma once

#include <string>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}

namespace collision_hulls {

struct XmlSource;

/// Notes on links whose elements urdfdom drops, as it reads a link no further than to an <inertial>, <visual> or <collision> that it cannot
/// read; on shapes beside the first of an element, which it does not look at; and on a description that it refuses. `root`: the <robot> as
/// it was written, whose joints form no loop. Elements without geometry are for GeometryStandIns to note.
std::vector<std::string> notesOnLosses(const XmlSource& subject, const tinyxml2::XMLElement& root);

}  // namespace collision_hulls
