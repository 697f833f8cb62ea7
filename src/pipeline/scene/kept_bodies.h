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

/// The primitives of links that are decomposed, but of `absent` ones; and all <collision> elements of links that are kept or not chosen.
/// An element that cannot be used, such as a dummy without a size or a mesh that cannot be read, only gives a note.
std::vector<KeptBody> keptBodies(const RobotDescription& robot, const LinkDecisions& decisions, const std::set<std::string>& absent,
                                 const PackageFinder& find_package, const Options& options, std::vector<std::string>& notes,
                                 const RunControl& control);

}  // namespace collision_hulls
