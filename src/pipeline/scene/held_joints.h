// Joints that stay where they are while a model is fitted: a planner that moves one arm needs no model for the other one's motions.
#pragma once

#include <map>
#include <string>

#include "collision_hulls/robot/kinematics.h"

namespace collision_hulls {

/// Where the joints stand [rad or m] that are held: those that `moving`, a regular expression, does not match as a whole, at rest, and
/// those that `at` names, there. An empty expression matches all. Mimic joints follow what they mimic; joints without room between their
/// limits do not count. Throws kBadOption for an expression that is none or that matches no joint with room, where no such joint is left,
/// and as Kinematics::configuration() does.
std::map<std::string, double> heldJoints(const Kinematics& kinematics, const std::string& moving, const std::map<std::string, double>& at);

/// The robot with no room between the limits of these joints. Its text stays as it is.
RobotDescription withJointsHeld(const RobotDescription& robot, const std::map<std::string, double>& held);

}  // namespace collision_hulls
