// Sampling within joint limits, and the collector that turns named positions into configurations: it carries unnamed joints over, checks
// limits and mimic joints, and interpolates. Notes keep the first and the largest of each deviation rather than one line per message.
#include "collision_hulls/scene/configurations.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/counted.h"
#include "base/decimal.h"
#include "base/looks.h"
#include "base/nearest_name.h"
#include "base/random.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "geometry/pi.h"
#include "scene/low_discrepancy.h"
#include "scene/reading.h"

namespace collision_hulls {
namespace {

constexpr double kTurn = 2 * kPi;
constexpr double kMimicDiffers = 1e-3;           // [rad or m]
constexpr double kFurthestPlace = 1e9;           // [rad or m] of a joint: a spindle turns for days until then
constexpr std::size_t kMostValues = 50'000'000;  // of all configurations: 400 MB

/// Before they take memory, which they do by their number and by the robot's joints.
void expectRoom(double configurations, std::size_t variables, const ConfigurationOptions& options, const std::string& where) {
  const double values = configurations * static_cast<double>(variables);
  if (configurations <= static_cast<double>(options.most) && values <= static_cast<double>(kMostValues)) return;
  const auto count = static_cast<std::uint64_t>(std::min(configurations, 1e18));  // a tiny step makes more than fit
  throw Error(ErrorCode::kTooLarge, where + ": that makes " + std::to_string(count) + " configurations of " + std::to_string(variables) +
                                        " variables, above the limit of " + std::to_string(options.most) + " configurations and " +
                                        std::to_string(kMostValues) + " values in all; give fewer" +
                                        (options.max_step > 0 ? ", or a larger step" : ""));
}

/// That poses, and steps between configurations, are finite: also of joints that mimic those that are named. Throws kBadConfigurations.
void expectNear(const std::map<std::string, NamedJoint>& joints, const Configuration& configuration, const std::string& where) {
  for (const auto& [name, joint] : joints) {
    if (joint.variable < 0) continue;
    const double place = joint.multiplier * configuration[static_cast<std::size_t>(joint.variable)] + joint.offset;
    if (!(std::abs(place) <= kFurthestPlace))
      failConfigurations(where, "joint '" + name + "' would be at " + decimal(place) + " rad or m; give positions within 1e9 of zero");
  }
}

}  // namespace

ConfigurationSequence::ConfigurationSequence(const Kinematics& kinematics, std::uint64_t seed, Sampling sampling)
    : variables_(kinematics.variables()), step_(richtmyerSteps(variables_.size())), sampling_(sampling) {
  for (std::size_t i = 0; i < variables_.size(); ++i) start_.push_back(mixed(mixed(seed) + i));
}

Configuration ConfigurationSequence::operator()(std::uint64_t index) const {
  Configuration result;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const std::uint64_t fraction = sampling_ == Sampling::kEven ? start_[i] + index * step_[i] : mixed(start_[i] ^ mixed(index));
    result.push_back(variables_[i].lower + unitInterval(fraction) * (variables_[i].upper - variables_[i].lower));
  }
  return result;
}

ConfigurationCollector::ConfigurationCollector(const Kinematics& kinematics, const ConfigurationOptions& options)
    : kinematics_(kinematics), options_(options), current_(kinematics.rest()), named_(kinematics.variables().size(), 0) {
  if (!(options.max_step >= 0 && std::isfinite(options.max_step))) {
    throw Error(ErrorCode::kBadOption,
                "max-step is " + decimal(options.max_step) + "; give 0, for no steps between configurations, or more");
  }
  for (const NamedJoint& joint : kinematics.joints()) joints_[joint.name] = joint;
}

void ConfigurationCollector::expectJoints(const std::vector<std::string>& names, const std::string& where) const {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (joints_.count(name) == 0) {
      std::vector<std::string> known;
      for (const auto& [joint, unused] : joints_) known.push_back(joint);
      failConfigurations(where, "the robot has no joint '" + shown(name) + "'; " +
                                    (known.empty() ? "it has no joints" : "its joints are " + listed(known) + didYouMean(name, known)));
    }
    if (!seen.insert(name).second) failConfigurations(where, "joint '" + name + "' appears twice; remove one");
  }
}

void ConfigurationCollector::add(const std::vector<std::string>& names, const std::vector<double>& positions, const std::string& where,
                                 const RunControl& control) {
  control.check();
  if (positions.empty() && !names.empty()) {
    if (without_positions_++ == 0) first_without_ = where + ", of joint '" + shown(names.front()) + "'";
    return;
  }
  if (names.size() != positions.size()) {
    failConfigurations(where,
                       counted(positions.size(), "position") + " for " + counted(names.size(), "joint") + "; give each joint one position");
  }
  expectJoints(names, where);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!std::isfinite(positions[i])) failConfigurations(where, "joint '" + names[i] + "' has a position that is not finite");
    put(joints_.at(names[i]), positions[i], where);
  }
  expectNear(joints_, current_, where);
  compareMimics(names, positions, where);
  append(current_, where, control);
  ++set_.given;
}

void ConfigurationCollector::put(const NamedJoint& joint, double position, const std::string& where) {
  if (joint.variable < 0) return;
  const auto index = static_cast<std::size_t>(joint.variable);
  const JointVariable& variable = kinematics_.variables()[index];
  if (variable.name != joint.name) return;  // a mimic
  current_[index] = position;
  named_[index] = 1;
  if (variable.continuous || withinLimits(variable, position)) return;
  const std::string text = beyondLimits(variable, position);
  if (options_.refuse_beyond_limits) failConfigurations(where, text);
  if (set_.beyond_limits++ == 0) first_beyond_ = where + ": " + text;
}

void ConfigurationCollector::compareMimics(const std::vector<std::string>& names, const std::vector<double>& positions,
                                           const std::string& where) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const NamedJoint& joint = joints_.at(names[i]);
    if (joint.variable < 0) continue;
    const double expected = joint.multiplier * current_[static_cast<std::size_t>(joint.variable)] + joint.offset;
    const double difference = std::abs(positions[i] - expected);
    if (!(difference > kMimicDiffers)) continue;
    Difference& known = differences_[joint.name];
    if (known.largest == 0) known.where = where;
    known.largest = std::max(known.largest, difference);
  }
}

void ConfigurationCollector::append(const Configuration& next, const std::string& where, const RunControl& control) {
  std::vector<Configuration>& all = set_.configurations;
  double steps = 1;
  Configuration way(next.size(), 0);
  if (follows_ && options_.max_step > 0) {
    const Configuration& last = all.back();
    for (std::size_t i = 0; i < next.size(); ++i) {
      way[i] = next[i] - last[i];
      if (kinematics_.variables()[i].continuous) way[i] = std::remainder(way[i], kTurn);
      steps = std::max(steps, std::ceil(std::abs(way[i]) / options_.max_step));
    }
  }
  expectRoom(static_cast<double>(all.size()) + steps, next.size(), options_, where);
  const Configuration begin = follows_ ? all.back() : next;
  Looks look(control, kLargeItemsBetweenLooks);
  for (double k = 1; k < steps; ++k) {
    look();
    Configuration between = begin;
    for (std::size_t i = 0; i < between.size(); ++i) between[i] += way[i] * k / steps;
    all.push_back(std::move(between));
  }
  all.push_back(next);
  follows_ = true;
}

ConfigurationSet ConfigurationCollector::take() {
  if (set_.beyond_limits > 0) {
    set_.notes.push_back(std::to_string(set_.beyond_limits) +
                         " values are beyond their limits and used unchanged; the first: " + first_beyond_);
  }
  for (const auto& [name, difference] : differences_) {
    set_.notes.push_back("mimic joint '" + name + "' is up to " + fixedDecimal(difference.largest) +
                         " away from where its master puts it, first in " + difference.where + "; the master's value is used");
  }
  if (without_positions_ > 0)
    set_.notes.push_back(counted(without_positions_, "message") + " without positions " + (without_positions_ == 1 ? "is" : "are") +
                         " passed over, the first: " + first_without_);
  std::string resting;
  for (std::size_t i = 0; i < named_.size(); ++i) {
    if (!named_[i]) resting += (resting.empty() ? "'" : ", '") + kinematics_.variables()[i].name + "'";
  }
  if (set_.given > 0 && !resting.empty()) set_.notes.push_back("joints that are never named stay at rest: " + resting);
  ConfigurationSet result = std::move(set_);
  set_ = {};
  first_beyond_.clear();
  without_positions_ = 0;
  differences_.clear();
  current_ = kinematics_.rest();
  named_.assign(named_.size(), 0);
  follows_ = false;
  return result;
}

}  // namespace collision_hulls
