// What holds for each link of a robot, once the options' rules are applied to it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The options of each link: those of all links, then the rules that match its name, in their
/// order, and its regions. Options that do not matter with a link's method have their defaults, so
/// that links with equal options are equal work.
class LinkDecisions {
 public:
  /// Throws kBadOption for an expression that matches no link, and for rules that contradict each
  /// other on a link: a setting or a region for one that is kept or removed, or a setting of method
  /// certified for a link with another method. Throws kCancelled.
  LinkDecisions(const Options& options, const RobotDescription& robot,
                const RunControl& control = {});

  /// nullptr: Options::links leaves the link alone.
  const LinkOptions* of(const std::string& link) const;

  /// The first link, in document order, with hulls of another method, and where that is written:
  /// "'panda.yaml', line 3"; empty: there is none.
  const std::string& firstOfOtherMethod() const { return other_method_; }
  const std::string& otherMethodPlace() const { return other_method_place_; }

 private:
  std::map<std::string, LinkOptions> links_;
  std::string other_method_, other_method_place_;
};

/// The region that a rule describes. Throws kBadOption.
Region regionOf(const RegionRule& rule);

/// The decisions of each of Options::models, or else of the only one. A tolerance that a rule gives
/// holds in every model.
std::vector<LinkDecisions> modelDecisions(const Options& options, const RobotDescription& robot,
                                          const RunControl& control = {});

/// Those of the first model alone.
LinkDecisions firstModelDecisions(Options options, const RobotDescription& robot,
                                  const RunControl& control = {});

}  // namespace collision_hulls
