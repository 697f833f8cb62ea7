// The bodies of a robot that a fit leaves as they are.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/control.h"
#include "collision_hulls/fit/fit.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The elements of the new description that are no hulls: primitives beside those, and all <collision> elements of links that keep them,
/// be it as the options say or because a mesh of theirs failed (`failed`: names of links). Of a link with one that cannot be used
/// there is none of these, and a note. Throws kCancelled.
std::vector<KeptBody> keptBodies(const RobotDescription& robot, const LinkDecisions& decisions, const std::set<std::string>& failed,
                                 const PackageFinder& find_package, const Options& options, std::vector<std::string>& notes,
                                 const RunControl& control);

}  // namespace collision_hulls
