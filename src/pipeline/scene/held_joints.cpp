// A joint is held by its limits, which leave it one place: all else that follows from the joints' ranges then does, too.
#include "pipeline/scene/held_joints.h"

#include <algorithm>
#include <vector>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "report/link_pattern.h"

namespace collision_hulls {

std::map<std::string, double> heldJoints(const Kinematics& kinematics, const std::string& moving, const std::map<std::string, double>& at) {
  if (moving.empty() && at.empty()) return {};
  const Configuration places = kinematics.configuration(at);
  const LinkPattern chosen(moving.empty() ? ".*" : moving, "joints");
  std::map<std::string, double> held;
  std::vector<std::string> movable;
  bool matched = false, moves = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const JointVariable& variable = kinematics.variables()[i];
    if (!(variable.lower < variable.upper)) continue;
    movable.push_back(variable.name);
    const bool is_chosen = chosen.matches(variable.name);
    matched = matched || is_chosen;
    if (is_chosen && at.count(variable.name) == 0)
      moves = true;
    else
      held[variable.name] = places[i];
  }
  if (movable.empty()) throw Error(ErrorCode::kBadOption, "the robot has no joint with room between its limits; omit joints and at");
  if (!matched)
    throw Error(ErrorCode::kBadOption,
                "joints '" + moving + "' matches no joint with room between its limits; those with room are " + listed(movable));
  if (!moves) throw Error(ErrorCode::kBadOption, "at holds each joint that could move, and one has to; leave one of them out");
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
