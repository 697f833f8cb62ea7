// The links of a robot, for messages.
#pragma once

#include <string>
#include <vector>

#include "base/string_parts.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// "a, b, c and 3 more"
inline std::string linkNames(const RobotDescription& robot) {
  constexpr std::size_t kShown = 12;
  std::vector<std::string> names;
  for (const LinkDescription& link : robot.links) names.push_back(link.name);
  return listedFirst(names, kShown);
}

}  // namespace collision_hulls
