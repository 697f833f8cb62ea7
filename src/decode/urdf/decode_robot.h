// From the text of a robot description to its meaning, in this process.
#pragma once

#include <string>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// What parseRobotDescription() does, but that `text` stays empty.
RobotDescription decodeRobot(const std::string& urdf_text, const std::string& path);

}  // namespace collision_hulls
