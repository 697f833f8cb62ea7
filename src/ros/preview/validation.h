// The hulls of links, whatever made them, compared with the links' meshes. Knows no ROS.
#pragma once

#include <map>
#include <string>

#include "collision_hulls/check/validate.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "ros/preview/robot_trees.h"

namespace collision_hulls {

/// Reads the meshes of these links again, and asks original and hulls the same queries. `options`: how meshes are read, and the seed.
/// Throws kBadOption where no link has hulls, what reading a mesh throws, kCancelled.
Validation validateLinks(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                         const std::map<std::string, LinkResult>& links, const RunControl& control, const StepCallback& step);

/// As in "1800 queries compared hulls and meshes: no collision missed, no false collision beyond the protrusion; ...".
std::string summary(const Validation& validation);

}  // namespace collision_hulls
