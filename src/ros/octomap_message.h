// From OctoMap's message to a scene. Built if octomap_msgs is installed.
#pragma once

#include <octomap_msgs/Octomap.h>

#include <string>

#include "collision_hulls/scene/octomap.h"

namespace collision_hulls {

/// The map in a message. It refers to the message's data.
Octomap toOctomap(const octomap_msgs::Octomap& message);

/// Boxes named "octomap/1", ...; see octomap.h. Throws kBadScene if the message is not in the root link's frame.
Scene toScene(const octomap_msgs::Octomap& message, const std::string& root_link, const RunControl& control = {});

}  // namespace collision_hulls
