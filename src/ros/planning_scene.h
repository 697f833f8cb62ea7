// MoveIt's planning scene to the library's; where moveit_msgs is installed.
#pragma once

#include <moveit_msgs/PlanningScene.h>

#include <string>

#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// Collision objects, of several shapes as "object/1", "object/2", ..., and the octomap, in the frame of the robot's root link: that of the
/// poses has to be it, one of fixed_frame_transforms, or the one that the robot state's only floating joint is in. What the robot holds,
/// links' padding and the allowed collisions are not looked at. Throws kBadScene; a difference to another scene is none.
Scene toScene(const moveit_msgs::PlanningScene& message, const std::string& root_link);

}  // namespace collision_hulls
