// Scenes that are published, rather than kept in a file.
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// Whether a scene is asked for by where it is published: "topic:NAME" or "service:NAME".
bool isLive(const std::string& source);

/// The scene of such a source, in the frame of the robot's root link:
///
///   topic:NAME      the next message, or the latched one: moveit_msgs/PlanningScene or octomap_msgs/Octomap
///   service:NAME    moveit_msgs/GetPlanningScene, as MoveIt's move_group has at /get_planning_scene
///
/// Waits for 10 s. Throws kBadOption where nobody publishes or serves it, for a message of another type, and for one whose package was not
/// there when this was built; kBadScene for what is no scene, or stands in a frame that the message does not tell from the root link's;
/// kCancelled.
Scene liveScene(const std::string& source, const std::string& root_link, const RunControl& control = {});

}  // namespace collision_hulls
