// What a fit to a scene refuses before any work.
#pragma once

#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// Throws kBadOption for what only decompose can do: other methods and shapes, padding, regions, trees of another tolerance, several
/// models, a time limit.
void refuseOtherWays(const RobotDescription& robot, const Options& options, const LinkDecisions& decisions);

/// Throws kBadOption for a clearance [m] that the robot never keeps from itself: the model would not have to be free anywhere.
void checkClearance(double clearance, const RobotDescription& robot);

}  // namespace collision_hulls
