// What Gazebo's contact sensors call collisions.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace collision_hulls {

/// The collisions that contact sensors in a description's <gazebo> elements name, and that no element of it is named as. Names that are
/// longer than any link's are left out. Throws XmlSyntaxError.
std::set<std::string> unnamedContacts(const std::string& urdf);

/// The links whose collision Gazebo may call so: <link>_collision and the like, or <parent>_fixed_joint_lump__<link>_collision where it
/// lumps the link and its parent together.
std::vector<std::string> linksOfCollision(const std::string& name);

}  // namespace collision_hulls
