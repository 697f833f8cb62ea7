// Scenes that nodes publish or serve, instead of files.
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// Whether a source names a topic or a service, as "topic:NAME" or "service:NAME".
bool isLive(const std::string& source);

/// The scene of such a source, in the frame of the robot's root link:
///
///   topic:NAME      the next message, or the latched one: moveit_msgs/PlanningScene or octomap_msgs/Octomap
///   service:NAME    moveit_msgs/GetPlanningScene, as MoveIt's move_group has at /get_planning_scene
///
/// Waits for up to 10 s. Throws kBadOption if nobody publishes or serves it, if the messages have another type, or if their package was
/// missing when this was built; kBadScene for a message that is no complete scene, or whose frames it does not relate to the root link's;
/// kCancelled.
Scene liveScene(const std::string& source, const std::string& root_link, const RunControl& control = {});

}  // namespace collision_hulls
