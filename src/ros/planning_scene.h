// From MoveIt's planning scene to the library's scene. Built if moveit_msgs is installed.
#pragma once

#include <moveit_msgs/PlanningScene.h>

#include <string>

#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// The collision objects and the octomap, in the frame of the robot's root link. An object of several shapes becomes "object/1",
/// "object/2", ... Poses must be in that frame, in one of fixed_frame_transforms, or in the parent frame of the robot state's only floating
/// joint. Ignores attached objects, padding and allowed collisions. Throws kBadScene, also for a message that is a difference to another
/// scene.
Scene toScene(const moveit_msgs::PlanningScene& message, const std::string& root_link, const RunControl& control = {});

}  // namespace collision_hulls
