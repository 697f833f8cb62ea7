// Goes through the rules once for each link. Which rule decided matters beyond its value: a setting may be told of links that an earlier,
// broader rule said something else about, and only the order tells an exception ("all fine, but keep this one") from a contradiction.
#include "collision_hulls/config/link_decisions.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "base/in_context.h"
#include "base/nearest_name.h"
#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "config/link_fields.h"
#include "geometry/roll_pitch_yaw.h"
#include "report/link_pattern.h"
#include "robot/link_names.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostRegionUses = 100'000;  // regions of each link, once for each of its elements

/// In front of a message.
std::string at(const std::string& place) {
  return place.empty() ? "" : place + ": ";
}

/// The first one that a region may be for, or the first of all.
std::string linkWithMesh(const RobotDescription& robot) {
  const auto is_mesh = [](const GeometryElement& element) { return element.kind == GeometryElement::Kind::kMesh; };
  const auto has_mesh = [&](const LinkDescription& link) {
    return std::any_of(link.visuals.begin(), link.visuals.end(), is_mesh) ||
           std::any_of(link.collisions.begin(), link.collisions.end(), is_mesh);
  };
  const auto first = std::find_if(robot.links.begin(), robot.links.end(), has_mesh);
  return first != robot.links.end() ? first->name : robot.links.empty() ? "base" : robot.links.front().name;
}

/// For a name that was misspelt, or a star as in a shell.
std::string suggestion(const std::string& expression, const RobotDescription& robot) {
  if (const std::string any = didYouMeanAny(expression); !any.empty()) return any;
  std::vector<std::string> names;
  for (const LinkDescription& link : robot.links) names.push_back(link.name);
  return didYouMean(expression, names);
}

/// The expressions of a list of rules, each of which has to match at least one link. Names are looked up: a program writes a rule for each
/// link. Other expressions are tried on every link, with a look at the control.
class Matchers {
 public:
  Matchers(const RobotDescription& robot, const RunControl& control) : robot_(robot), control_(control) {
    for (const LinkDescription& link : robot.links) by_link_[link.name];
  }

  void add(const std::string& expression, const std::string& option, const std::string& place) {
    LinkPattern pattern(expression, at(place) + option);
    const std::size_t index = count_++;
    bool matches = false;
    if (pattern.names()) {
      for (const std::string& name : *pattern.names()) {
        const auto link = by_link_.find(name);
        if (link == by_link_.end()) continue;
        link->second.push_back(index);
        matches = true;
      }
    } else {
      matches = std::any_of(robot_.links.begin(), robot_.links.end(), [&](const auto& link) { return isMatch(pattern, link.name); });
      others_.emplace_back(index, std::move(pattern));
    }
    if (!matches)
      throw Error(ErrorCode::kBadOption, at(place) + option + " '" + expression + "' matches no link of robot '" + robot_.name +
                                             "' (the expression has to match the whole name). Its links are " + linkNames(robot_) +
                                             suggestion(expression, robot_));
  }

  /// The expressions that match a link, by their places in the list, ascending.
  std::vector<std::size_t> of(const std::string& link) const {
    std::vector<std::size_t> matching = by_link_.at(link);
    for (const auto& [index, pattern] : others_)
      if (isMatch(pattern, link)) matching.push_back(index);
    std::sort(matching.begin(), matching.end());
    return matching;
  }

 private:
  bool isMatch(const LinkPattern& pattern, const std::string& link) const {
    control_.check();
    return pattern.matches(link);
  }

  const RobotDescription& robot_;
  const RunControl& control_;
  std::size_t count_ = 0;
  std::unordered_map<std::string, std::vector<std::size_t>> by_link_;  // lists of names that have it
  std::vector<std::pair<std::size_t, LinkPattern>> others_;
};

/// The first setting but the action; empty: there is none.
std::string firstSetting(const LinkSettings& settings) {
  std::string first;
  forEachLinkField([&](const char* name, auto option, auto setting) {
    (void)option;
    if (first.empty() && settings.*setting && name != std::string("action")) first = name;
  });
  return first;
}

bool mayContradictShapes(const LinkSettings& settings) {
  return settings.method.value_or(Method::kCertified) != Method::kCertified || settings.shapes.value_or(Shapes::kHulls) != Shapes::kHulls ||
         settings.fill.value_or(false) || settings.padding.value_or(0) > 0;
}

/// The options of one link while the rules are applied to it.
class Decision {
 public:
  Decision(const std::string& link, const LinkOptions& defaults) : link_(link), options_(defaults) {}

  void apply(const LinkRule& rule) {
    collision_hulls::apply(rule.settings, options_);
    if (rule.settings.action) action_place_ = rule.place;
    if (rule.settings.method) method_place_ = rule.place;
    if (mayContradictShapes(rule.settings)) shapes_place_ = rule.place;
    const std::string setting = firstSetting(rule.settings);
    if (options_.action != Action::kDecompose && !setting.empty())
      refuse(rule, setting, std::string(options_.action == Action::kKeep ? "is kept" : "is removed") + " by " + action_place_,
             "or add action: decompose");
    if (options_.method == Method::kCertified) return;
    const std::string why = std::string("has method '") + name(options_.method) + "'" +
                            (method_place_.empty() ? "" : " from " + method_place_) + ", and only 'certified' has this setting";
    if (rule.settings.effort && needsCertified(*rule.settings.effort)) refuse(rule, "effort", why, "or add method: certified");
    if (rule.settings.fill == true) refuse(rule, "fill", why, "or add method: certified");
  }

  void add(const RegionRule& rule) {
    if (options_.action != Action::kDecompose)
      throw Error(ErrorCode::kBadOption, at(rule.place) + "region '" + rule.name + "' holds for link '" + link_ + "', which " +
                                             (options_.action == Action::kKeep ? "is kept" : "is removed") + " by " + action_place_ +
                                             ": leave one of them out");
    if (options_.padding > 0)
      throw Error(ErrorCode::kBadOption, at(rule.place) + "region '" + rule.name + "' holds for link '" + link_ +
                                             "', whose hulls are padded by " + toString(lengthOf(options_.padding)) +
                                             ": leave one of them out, or give the link padding: 0");
    options_.regions.push_back(regionOf(rule));
    shapes_place_ = rule.place;
  }

  /// Without what does not matter. A tree knows nothing of regions.
  LinkOptions options() const {
    LinkOptions result = options_;
    if (result.action == Action::kDecompose) inContext(at(shapes_place_) + "link '" + link_ + "'", [&] { checkShapes(result); });
    if (result.method != Method::kCertified) {
      result.effort = Effort::kQuick;
      result.fill = false;
      result.tree.reset();
    }
    if (!result.regions.empty()) result.tree.reset();
    if (result.method == Method::kSingleHull || result.method == Method::kBoundingBox) result.max_hulls = 0;
    return result;
  }
  const std::string& methodPlace() const { return method_place_; }

 private:
  [[noreturn]] void refuse(const LinkRule& rule, const std::string& setting, const std::string& why, const std::string& remedy) const {
    throw Error(ErrorCode::kBadOption, at(rule.place) + setting + " of links '" + rule.pattern + "' holds for link '" + link_ +
                                           "', which " + why + ": the last rule counts, so move that rule below this one, " + remedy +
                                           " here");
  }

  const std::string& link_;
  LinkOptions options_;
  std::string action_place_, method_place_;
  std::string shapes_place_;  // of what was decided last among settings that may contradict shapes
};

}  // namespace

LinkDecisions::LinkDecisions(const Options& options, const RobotDescription& robot, const RunControl& control) {
  Matchers only(robot, control), rules(robot, control), regions(robot, control);
  if (!options.links.empty()) only.add(options.links, options.links_place.empty() ? "links" : "only", options.links_place);
  for (const LinkRule& rule : options.rules) rules.add(rule.pattern, "links", rule.place);
  for (const RegionRule& rule : options.region_rules) {
    if (rule.pattern.empty())
      throw Error(ErrorCode::kBadOption, at(rule.place) + "region '" + rule.name + "' names no link of robot '" + robot.name +
                                             "': add one, as in link: " + linkWithMesh(robot));
    regions.add(rule.pattern, "region '" + rule.name + "': its link", rule.place);
  }
  std::size_t region_uses = 0;
  for (const LinkDescription& link : robot.links) {
    control.check();
    if (!options.links.empty() && only.of(link.name).empty()) continue;
    Decision decision(link.name, options);
    for (const std::size_t rule : rules.of(link.name)) decision.apply(options.rules[rule]);
    for (const std::size_t region : regions.of(link.name)) {
      const RegionRule& rule = options.region_rules[region];
      region_uses += std::max<std::size_t>(1, link.visuals.size() + link.collisions.size());
      if (region_uses > kMostRegionUses)
        throw Error(ErrorCode::kBadOption, at(rule.place) + "with region '" + rule.name + "' of link '" + link.name +
                                               "', regions are used " + std::to_string(region_uses) +
                                               " times, once for each element of their links; at most " + std::to_string(kMostRegionUses) +
                                               " uses are allowed: let regions hold for fewer links");
      decision.add(rule);
    }
    const LinkOptions& decided = links_[link.name] = decision.options();
    if (other_method_.empty() && decided.action == Action::kDecompose && decided.method != Method::kCertified) {
      other_method_ = link.name;
      other_method_place_ = decision.methodPlace();
    }
  }
}

const LinkOptions* LinkDecisions::of(const std::string& link) const {
  const auto found = links_.find(link);
  return found == links_.end() ? nullptr : &found->second;
}

Region regionOf(const RegionRule& rule) {
  Region region;
  if (const auto* const box = std::get_if<RegionBox>(&rule.shape)) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = fromRollPitchYaw(box->rpy).toRotationMatrix();
    pose.translation() = box->center;
    region = boxRegion(box->size, pose, rule.tolerance);
  } else {
    const auto& half_space = std::get<RegionHalfSpace>(rule.shape);
    region = halfSpaceRegion(half_space.normal, half_space.offset, rule.tolerance);
  }
  region.name = rule.name;
  return region;
}

std::vector<LinkDecisions> modelDecisions(const Options& options, const RobotDescription& robot, const RunControl& control) {
  if (options.models.empty()) return {LinkDecisions(options, robot, control)};
  std::vector<LinkDecisions> decisions;
  for (const ModelOptions& model : options.models) {
    Options of_model = options;
    of_model.tolerance = model.tolerance;
    decisions.emplace_back(of_model, robot, control);
  }
  return decisions;
}

LinkDecisions firstModelDecisions(Options options, const RobotDescription& robot, const RunControl& control) {
  options.models.resize(std::min<std::size_t>(options.models.size(), 1));
  return modelDecisions(options, robot, control).front();
}

}  // namespace collision_hulls
