// How the joints of two descriptions differ, apart from where they put their links.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// For each link that both have, and whose joint has another kind, axis, range or mimic in RESULT: the joint and the first of these, as in
/// "'elbow', which is continuous there and is revolute in ORIGINAL". Joints above a link are compared whatever their names.
std::vector<std::string> jointDifferences(const RobotDescription& original, const RobotDescription& result);

}  // namespace collision_hulls
