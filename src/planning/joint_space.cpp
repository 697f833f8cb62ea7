// Chooses the joints by name, and walks along paths through their values.
#include "planning/joint_space.h"

#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "geometry/pi.h"
#include "report/link_pattern.h"

namespace collision_hulls {
namespace {

std::string namesOf(const std::vector<JointVariable>& variables) {
  std::string names;
  for (const JointVariable& variable : variables) names += (names.empty() ? "" : ", ") + variable.name;
  return names;
}

/// How far a joint moves, with a sign.
double travel(const JointVariable& joint, double from, double to) {
  const double straight = to - from;
  return joint.continuous ? std::remainder(straight, 2 * kPi) : straight;
}

}  // namespace

JointSpace::JointSpace(const Kinematics& kinematics, const std::string& pattern, const std::map<std::string, double>& others)
    : kinematics_(kinematics), others_(kinematics.configuration(others)) {
  const LinkPattern chosen(pattern.empty() ? ".*" : pattern, "joints");
  const std::vector<JointVariable>& all = kinematics.variables();
  bool held = false;  // is one that would be planned
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!chosen.matches(all[i].name) || !(all[i].lower < all[i].upper)) continue;
    if (others.count(all[i].name) > 0) {
      held = true;
      continue;
    }
    joints_.push_back(all[i]);
    variables_.push_back(i);
  }
  if (!joints_.empty()) return;
  if (held) throw Error(ErrorCode::kBadOption, "at holds each joint that could be planned; leave one of them out");
  throw Error(ErrorCode::kBadOption,
              all.empty()
                  ? "the robot has no movable joint, and nothing to plan; give another robot"
                  : "joints '" + pattern + "' matches no joint with room between its limits; the movable joints are " + namesOf(all));
}

Configuration JointSpace::configuration(const JointValues& values) const {
  Configuration all = others_;
  for (std::size_t i = 0; i < variables_.size(); ++i) all[variables_[i]] = values[i];
  return all;
}

JointValues JointSpace::values(const Configuration& configuration) const {
  JointValues values;
  for (const std::size_t variable : variables_) values.push_back(configuration[variable]);
  return values;
}

std::vector<ChainJoint> JointSpace::way(std::size_t link) const {
  std::vector<ChainJoint> joints = kinematics_.chain(link).joints;
  const auto is_planned = [&](const ChainJoint& joint) {
    return std::find(variables_.begin(), variables_.end(), joint.variable) != variables_.end();
  };
  while (!joints.empty() && !is_planned(joints.back())) joints.pop_back();
  return joints;
}

bool JointSpace::moves(std::size_t link, std::size_t other) const {
  const std::vector<ChainJoint> one = way(link), two = way(other);
  return !std::equal(one.begin(), one.end(), two.begin(), two.end(), equalJoints);
}

JointValues between(const std::vector<JointVariable>& joints, const JointValues& from, const JointValues& to, double share) {
  JointValues values(joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) values[i] = from[i] + share * travel(joints[i], from[i], to[i]);
  return values;
}

std::vector<JointValues> alongPath(const std::vector<JointVariable>& joints, const std::vector<JointValues>& path, double step) {
  std::vector<JointValues> along;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    double steps = 1;
    for (std::size_t i = 0; i < joints.size(); ++i)
      steps = std::max(steps,
                       std::ceil(std::abs(travel(joints[i], path[k][i], path[k + 1][i])) / (step * (joints[i].upper - joints[i].lower))));
    for (double n = 0; n < steps; ++n) along.push_back(between(joints, path[k], path[k + 1], n / steps));
  }
  if (!path.empty()) along.push_back(path.back());
  return along;
}

}  // namespace collision_hulls
