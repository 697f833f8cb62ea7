// A joint is held by its limits, which leave it one place: all else that follows from the joints' ranges then does, too.
#include "pipeline/scene/held_joints.h"

#include <algorithm>
#include <vector>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/kinematics.h"
#include "report/link_pattern.h"

namespace collision_hulls {

std::map<std::string, double> heldJoints(const RobotDescription& robot, const std::string& moving,
                                         const std::map<std::string, double>& at) {
  if (moving.empty() && at.empty()) return {};
  const Kinematics kinematics(robot);
  const Configuration places = kinematics.configuration(at);
  const LinkPattern chosen(moving.empty() ? ".*" : moving, "joints");
  std::map<std::string, double> held;
  std::vector<std::string> movable;
  bool matched = false, moves = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const JointVariable& variable = kinematics.variables()[i];
    const bool has_room = variable.lower < variable.upper, is_chosen = chosen.matches(variable.name);
    if (has_room) movable.push_back(variable.name);
    matched = matched || (has_room && is_chosen);
    if (is_chosen && at.count(variable.name) == 0)
      moves = moves || has_room;
    else
      held[variable.name] = places[i];
  }
  if (!matched)
    throw Error(ErrorCode::kBadOption, "joints '" + moving + "' matches no joint with room between its limits" +
                                           (movable.empty() ? "" : "; those with room are " + listed(movable)));
  if (!moves) throw Error(ErrorCode::kBadOption, "at holds every joint that could move; leave out the position of one at least");
  return held;
}

RobotDescription withJointsHeld(const RobotDescription& robot, const std::map<std::string, double>& held) {
  RobotDescription result = robot;
  for (JointDescription& joint : result.joints) {
    const auto place = held.find(joint.name);
    if (place == held.end()) continue;
    if (joint.kind == JointDescription::Kind::kContinuous) joint.kind = JointDescription::Kind::kRevolute;
    joint.lower = joint.upper = place->second;
  }
  return result;
}

}  // namespace collision_hulls
