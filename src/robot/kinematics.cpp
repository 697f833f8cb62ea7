// Forward kinematics from the root to the leaves. A mimic joint is reduced to the one variable that moves it when the tree is read.
#include "collision_hulls/robot/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/decimal.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "geometry/pi.h"
#include "robot/far_away.h"

namespace collision_hulls {
namespace {

using Kind = JointDescription::Kind;

constexpr double kBeyondLimit = 1e-6;              // of the limits' size: what decimal text may have rounded away
constexpr std::size_t kMostListed = 12;            // joints in a message
constexpr double kUnitLength = 1e-9;               // of an axis: what rounding may add or take away
constexpr std::size_t kMostUnsettled = 1'000'000;  // joints above links, in all

/// Within limits that are those of no mechanism, such as the largest number.
bool slidesAnywhere(const JointDescription& joint) {
  const auto is_far = [](double metres) { return !(std::abs(metres) <= kFurthestOrigin); };
  return joint.kind == Kind::kPrismatic && joint.mimic.empty() && (is_far(joint.lower) || is_far(joint.upper));
}

bool canMove(const JointDescription& joint) {
  const bool has_kind = joint.kind == Kind::kRevolute || joint.kind == Kind::kContinuous || joint.kind == Kind::kPrismatic;
  return has_kind && !slidesAnywhere(joint);
}

bool placesRobot(const JointDescription& joint) {
  return joint.kind == Kind::kFloating || joint.kind == Kind::kPlanar || slidesAnywhere(joint);
}

/// The joint that moves another one, and how.
struct Drive {
  const JointDescription* master = nullptr;
  double multiplier = 1, offset = 0;
};

/// What moves each joint of a robot.
class Drives {
 public:
  explicit Drives(const std::vector<JointDescription>& joints) {
    for (const JointDescription& joint : joints) by_name_[joint.name] = {&joint, {}};
  }

  /// The drive of a joint that can move. Throws kNotARobot for a <mimic> that leads nowhere, or back to the joint.
  const Drive& of(const JointDescription& joint) {
    std::vector<Known*> mimics;  // from `joint` towards its master
    Known* at = &by_name_.at(joint.name);
    for (; !at->drive.master && !at->joint->mimic.empty(); at = &mimicked(*at->joint)) {
      mimics.push_back(at);
      if (mimics.size() > by_name_.size()) fail(*at->joint, "leads back to itself; correct one of their <mimic> elements");
    }
    if (!at->drive.master) at->drive.master = at->joint;
    for (; !mimics.empty(); mimics.pop_back()) {
      const Drive& above = at->drive;
      at = mimics.back();
      const double multiplier = at->joint->mimic_multiplier;
      at->drive = {above.master, multiplier * above.multiplier, at->joint->mimic_offset + multiplier * above.offset};
    }
    return at->drive;
  }

 private:
  struct Known {
    const JointDescription* joint = nullptr;
    Drive drive;  ///< without a master until it is asked for
  };

  [[noreturn]] static void fail(const JointDescription& joint, const std::string& reason) {
    throw Error(ErrorCode::kNotARobot, "joint '" + joint.name + "' mimics '" + joint.mimic + "', which " + reason);
  }

  Known& mimicked(const JointDescription& joint) {
    const auto found = by_name_.find(joint.mimic);
    if (found == by_name_.end()) fail(joint, "the robot does not have; correct its <mimic>");
    if (!canMove(*found->second.joint)) fail(joint, "does not move; correct its <mimic>");
    return found->second;
  }

  std::map<std::string, Known> by_name_;
};

/// Of a joint that mimics, as its master goes from limit to limit. Throws kNotARobot.
void expectRange(const JointDescription& joint, const Drive& drive, const JointVariable& master) {
  const double first = drive.multiplier * master.lower + drive.offset, last = drive.multiplier * master.upper + drive.offset;
  const bool slides = joint.kind == Kind::kPrismatic;
  if (std::isfinite(last - first) && (!slides || std::max(std::abs(first), std::abs(last)) <= kFurthestOrigin)) return;
  throw Error(ErrorCode::kNotARobot, "joint '" + joint.name + "' follows '" + master.name + "' from " + decimal(first) + " to " +
                                         decimal(last) + (slides ? " m, more than 1000 km away" : " rad, which is not a range") +
                                         "; correct the numbers of its <mimic>");
}

[[noreturn]] void refuse(const std::string& text) {
  throw Error(ErrorCode::kNotARobot, text);
}

/// The links by their names. Throws kNotARobot unless each joint leads down, to a link that no joint before it names. What is read from a
/// URDF is like that.
std::map<std::string, std::size_t> linksInTree(const RobotDescription& robot) {
  std::map<std::string, std::size_t> links;
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    if (!links.emplace(robot.links[i].name, i).second) refuse("link '" + robot.links[i].name + "' appears twice; rename one of them");
  std::set<std::string> joints, named;
  for (const JointDescription& joint : robot.joints) {
    const std::string who = "joint '" + joint.name + "' ";
    if (!joints.insert(joint.name).second) refuse(who + "appears twice; rename one of them");
    for (const std::string* const link : {&joint.parent, &joint.child})
      if (links.count(*link) == 0) refuse(who + "names link '" + *link + "', which the robot does not have; correct it, or add the link");
    named.insert(joint.parent);
    if (!named.insert(joint.child).second)
      refuse(who + "leads to link '" + joint.child + "', which is its parent or that of a joint before it, or has a joint already; give " +
             "each link one joint that leads to it, those nearest to the root first");
  }
  return links;
}

}  // namespace

bool withinLimits(const JointVariable& variable, double value) {
  const double slack = kBeyondLimit * std::max(std::abs(variable.lower), std::abs(variable.upper));
  return value >= variable.lower - slack && value <= variable.upper + slack;
}

std::string beyondLimits(const JointVariable& variable, double value) {
  constexpr double kTurn = 2 * kPi;  // positions above it are more often degrees or millimetres than slips
  return "joint '" + variable.name + "' at " + fixedDecimal(value) + " is beyond its limits, " + fixedDecimal(variable.lower) + " to " +
         fixedDecimal(variable.upper) + (std::abs(value) > kTurn ? "; positions are in radians, or metres" : "");
}

bool equalJoints(const ChainJoint& a, const ChainJoint& b) {
  return a.turns == b.turns && a.variable == b.variable && a.multiplier == b.multiplier && a.offset == b.offset && a.axis == b.axis &&
         a.origin.matrix() == b.origin.matrix();
}

Eigen::Isometry3d motion(const JointDescription& joint, double value) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (joint.kind == Kind::kRevolute || joint.kind == Kind::kContinuous) {
    result.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
  } else if (joint.kind == Kind::kPrismatic) {
    result.translation() = value * joint.axis;
  }
  return result;
}

Eigen::Isometry3d motion(const ChainJoint& joint, double value) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (joint.turns) {
    result.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
  } else {
    result.translation() = value * joint.axis;
  }
  return result;
}

double restValue(const JointDescription& joint) {
  return std::clamp(0.0, joint.lower, joint.upper);
}

Kinematics::Kinematics(const RobotDescription& robot) : links_(robot.links.size()), parent_(links_) {
  const std::map<std::string, std::size_t> link_index = linksInTree(robot);
  Drives drives(robot.joints);
  std::map<std::string, int> variable_index;
  for (const JointDescription& joint : robot.joints) {
    if (!canMove(joint) || !joint.mimic.empty()) continue;
    variable_index[joint.name] = static_cast<int>(variables_.size());
    variables_.push_back({joint.name, joint.lower, joint.upper, joint.kind == Kind::kContinuous});
  }
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  body_ = parent_;
  unsettled_.resize(links_);
  std::size_t unsettled = 0;
  for (const JointDescription& description : robot.joints) {
    check(description);
    Joint joint{description, link_index.at(description.parent), link_index.at(description.child)};
    if (canMove(description)) {
      const Drive& drive = drives.of(description);
      joint.variable = variable_index.at(drive.master->name);
      joint.multiplier = drive.multiplier;
      joint.offset = drive.offset;
      if (!description.mimic.empty()) expectRange(description, drive, variables_[static_cast<std::size_t>(joint.variable)]);
      const bool comes_back = description.kind != Kind::kPrismatic && drive.multiplier == std::round(drive.multiplier);
      joint.paced = drive.master->kind == Kind::kContinuous && drive.multiplier != 0 && !comes_back;
    }
    parent_[joint.child] = joint.parent;
    if (!canMove(description) && !placesRobot(description)) body_[joint.child] = body_[joint.parent];
    unsettled_[joint.child] = unsettled_[joint.parent];
    if (joint.paced || placesRobot(description)) unsettled_[joint.child].push_back(joints_.size());
    unsettled += unsettled_[joint.child].size();
    if (unsettled > kMostUnsettled)
      throw Error(ErrorCode::kNotARobot,
                  "floating and planar joints, counted once for each link below them, are more than a million; "
                  "fix some of these joints");
    joints_.push_back(std::move(joint));
  }
  findEnds(robot.links);
}

/// Links without geometry that fixed joints join are one place, which stands for the link with geometry at it. Where several are, nobody
/// knows which of them touches what the joint moves.
void Kinematics::findEnds(const std::vector<LinkDescription>& links) {
  const auto is_bare = [&](std::size_t link) { return links[link].collisions.empty() && links[link].visuals.empty(); };
  std::vector<std::size_t> place(links_), at_place(links_, links_);
  std::vector<char> is_shared(links_, 0);
  std::iota(place.begin(), place.end(), std::size_t{0});
  const auto put = [&](std::size_t link, std::size_t at) {
    if (at_place[at] != links_) is_shared[at] = 1;
    at_place[at] = link;
  };
  for (const Joint& joint : joints_) {
    if (body_[joint.child] != body_[joint.parent]) continue;
    if (is_bare(joint.parent) && is_bare(joint.child)) place[joint.child] = place[joint.parent];
    if (is_bare(joint.parent) && !is_bare(joint.child)) put(joint.child, place[joint.parent]);
    if (!is_bare(joint.parent) && is_bare(joint.child)) put(joint.parent, joint.child);
  }
  end_.resize(links_);
  for (std::size_t i = 0; i < links_; ++i) {
    const std::size_t at = place[i];
    end_[i] = is_bare(i) && at_place[at] != links_ ? (is_shared[at] ? links_ : at_place[at]) : i;
  }
}

std::vector<NamedJoint> Kinematics::joints() const {
  std::vector<NamedJoint> result;
  for (const Joint& joint : joints_) result.push_back({joint.description.name, joint.variable, joint.multiplier, joint.offset});
  return result;
}

Configuration Kinematics::rest() const {
  Configuration result;
  for (const JointVariable& variable : variables_) result.push_back(std::clamp(0.0, variable.lower, variable.upper));
  return result;
}

Configuration Kinematics::configuration(const std::map<std::string, double>& values) const {
  Configuration result = rest();
  for (const auto& [name, value] : values) {
    const auto named = [&name = name](const JointVariable& variable) { return variable.name == name; };
    const auto found = std::find_if(variables_.begin(), variables_.end(), named);
    if (found == variables_.end()) {
      std::vector<std::string> others;
      for (const JointVariable& variable : variables_) others.push_back(variable.name);
      throw Error(ErrorCode::kBadOption,
                  "joint '" + name + "' cannot be set: the robot has no such joint, or it is fixed or mimics another; " +
                      (others.empty() ? "no joint can be set" : "those that can be set are " + listedFirst(others, kMostListed)));
    }
    if (found->continuous ? !std::isfinite(value) : !withinLimits(*found, value))
      throw Error(ErrorCode::kBadOption, beyondLimits(*found, value));
    result[static_cast<std::size_t>(found - variables_.begin())] = value;
  }
  return result;
}

Configuration Kinematics::sample(const std::function<double()>& uniform) const {
  Configuration result;
  for (const JointVariable& variable : variables_) result.push_back(variable.lower + uniform() * (variable.upper - variable.lower));
  return result;
}

void Kinematics::check(const Configuration& configuration) const {
  if (configuration.size() != variables_.size()) {
    throw Error(ErrorCode::kBadOption, "a configuration of size " + std::to_string(configuration.size()) +
                                           " was given; the size has to be " + std::to_string(variables_.size()) +
                                           ", a value for each joint that can be set");
  }
  for (std::size_t i = 0; i < configuration.size(); ++i)
    if (!std::isfinite(configuration[i]))
      throw Error(ErrorCode::kBadOption, "a configuration has the value " + decimal(configuration[i]) + " for joint '" +
                                             variables_[i].name + "'; it must be finite");
}

std::vector<Eigen::Isometry3d> Kinematics::poses(const Configuration& configuration) const {
  check(configuration);
  std::vector<Eigen::Isometry3d> result(links_, Eigen::Isometry3d::Identity());
  for (const Joint& joint : joints_) {
    const double value = joint.variable < 0 ? 0 : joint.multiplier * configuration[static_cast<std::size_t>(joint.variable)] + joint.offset;
    result[joint.child] = result[joint.parent] * joint.description.origin * motion(joint.description, value);
  }
  return result;
}

Chain Kinematics::chain(std::size_t link) const {
  std::vector<const Joint*> way;  // from the link to the root
  for (auto joint = joints_.rbegin(); joint != joints_.rend(); ++joint) {
    if (joint->child == (way.empty() ? link : way.back()->parent)) way.push_back(&*joint);
  }
  Chain result;
  for (auto joint = way.rbegin(); joint != way.rend(); ++joint) {
    const JointDescription& description = (*joint)->description;
    result.end = result.end * description.origin;
    if ((*joint)->variable < 0) continue;
    const bool turns = description.kind != Kind::kPrismatic;
    const auto variable = static_cast<std::size_t>((*joint)->variable);
    result.joints.push_back({turns, result.end, description.axis, variable, (*joint)->multiplier, (*joint)->offset});
    result.end.setIdentity();
  }
  return result;
}

bool Kinematics::adjacent(std::size_t link, std::size_t other) const {
  const auto hangs_on = [&](std::size_t below, std::size_t above) {
    const std::size_t child = body_[below];
    return end_[child] == below && end_[parent_[child]] == above;
  };
  return body_[link] == body_[other] || hangs_on(link, other) || hangs_on(other, link);
}

bool Kinematics::settled(std::size_t link, std::size_t other) const {
  return unsettled_[link] == unsettled_[other];
}

bool Kinematics::settled(std::size_t link) const {
  return std::none_of(unsettled_[link].begin(), unsettled_[link].end(), [&](std::size_t joint) { return joints_[joint].paced; });
}

std::vector<std::string> Kinematics::notes() const {
  std::vector<std::string> notes;
  for (const Joint& joint : joints_) {
    const JointDescription& what = joint.description;
    const std::string who = "joint '" + what.name + "' ";
    if (placesRobot(what)) {
      const char* const how = what.kind == Kind::kFloating ? "floats"
                              : what.kind == Kind::kPlanar ? "is planar"
                                                           : "slides more than 1000 km";
      notes.push_back(who + how + ": it stays at its origin, and nothing is proved between links on opposite sides of it");
    } else if (joint.paced) {
      notes.push_back(who + "follows the continuous joint '" + variables_[static_cast<std::size_t>(joint.variable)].name +
                      "' at another ratio: one turn of that joint is sampled, and nothing is proved about what this one moves");
    } else if (canMove(what) && what.mimic.empty() && what.kind != Kind::kContinuous && !(what.lower < what.upper)) {
      notes.push_back(who + "stays at " + fixedDecimal(what.lower) + ": its limits are missing, equal or crossed");
    }
  }
  return notes;
}

void Kinematics::check(const JointDescription& joint) const {
  const std::string who = "joint '" + joint.name + "' ";
  if (isFarAway(joint.origin))
    throw Error(ErrorCode::kNotARobot, who + "has an origin that is no pose, or more than 1000 km away; correct its <origin>");
  if (!std::isfinite(joint.lower) || !(joint.lower <= joint.upper) || !std::isfinite(joint.upper))
    refuse(who + "has the limits " + decimal(joint.lower) + " and " + decimal(joint.upper) +
           "; give finite ones that do not cross, both 0 where there are none");
  if (canMove(joint) && !(std::abs(joint.axis.norm() - 1) <= kUnitLength))
    refuse(who + "has an axis of length " + decimal(joint.axis.norm()) + "; give one of length 1");
}

}  // namespace collision_hulls
