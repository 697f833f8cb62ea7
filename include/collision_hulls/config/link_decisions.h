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
  /// Throws kBadOption for an expression that is invalid or matches no link, a region that
  /// regionOf() refuses or that names no link, and rules that contradict each other on a link: a
  /// setting or a region for one that is kept or removed, a region where hulls are padded, a
  /// setting of the method certified with another method, or what checkShapes() refuses. Throws
  /// kCancelled.
  LinkDecisions(const Options& options, const RobotDescription& robot,
                const RunControl& control = {});

  /// nullptr: Options::links leaves the link alone, or the robot does not have it.
  const LinkOptions* of(const std::string& link) const;

  /// The first link, in document order, with hulls of a method other than certified, and where that
  /// is written: "'panda.yaml', line 3"; empty: there is none.
  const std::string& firstOfOtherMethod() const { return other_method_; }
  const std::string& otherMethodPlace() const { return other_method_place_; }

 private:
  std::map<std::string, LinkOptions> links_;
  std::string other_method_, other_method_place_;
};

/// The region that a rule describes. Throws kBadOption as boxRegion() and halfSpaceRegion().
Region regionOf(const RegionRule& rule);

/// The decisions of each of Options::models, or else of the only one. A tolerance that a rule gives
/// holds in every model. Throws as LinkDecisions.
std::vector<LinkDecisions> modelDecisions(const Options& options, const RobotDescription& robot,
                                          const RunControl& control = {});

/// Those of the first model alone.
LinkDecisions firstModelDecisions(Options options, const RobotDescription& robot,
                                  const RunControl& control = {});

}  // namespace collision_hulls
