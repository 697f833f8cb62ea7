// From hulls to the collision model of a robot: file names, URIs, and the rewritten description.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/pipeline/decompose_robot.h"

namespace collision_hulls {

/// Puts the elements' rows into the report, with a file for each hull, relative to the output folder. A robot's lie in meshes/<link>/, a
/// single mesh's in the folder itself, its OBJ of all hulls first.
void reportElements(RobotResult& result);

/// The name of the ROS package that a robot's output is.
std::string outputPackage(const std::string& robot_name);

/// Where the rewritten description lies in the output folder.
std::string urdfFile(const std::string& robot_name);

/// Writes the description anew, with a <collision> for every hull; a link with a failed mesh keeps what it has. Adds notes to the report:
/// what was amiss in what was read, `notes`, and what the user of the new description should know, such as meshes that it still names
/// relative to the old one's place.
void rewriteDescription(const RobotDescription& robot, const std::string& output, const std::vector<std::string>& notes,
                        RobotResult& result);

}  // namespace collision_hulls
