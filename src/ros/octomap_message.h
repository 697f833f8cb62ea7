// OctoMap's message to a scene; where octomap_msgs is installed.
#pragma once

#include <octomap_msgs/Octomap.h>

#include <string>

#include "collision_hulls/scene/octomap.h"

namespace collision_hulls {

/// The map that a message holds; its data stays the message's.
Octomap toOctomap(const octomap_msgs::Octomap& message);

/// Boxes "octomap/1", ...: see octomap.h. Throws kBadScene for a message that is not in the root link's frame.
Scene toScene(const octomap_msgs::Octomap& message, const std::string& root_link);

}  // namespace collision_hulls
