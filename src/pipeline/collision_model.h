// From hulls to the collision model of a robot: file names, URIs, and the rewritten description.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/pipeline/decompose_robot.h"

namespace collision_hulls {

/// Fills report.files: a file for each hull, relative to the output folder. A robot's lie in meshes/<link>/, a single mesh's
/// in the folder itself, its OBJ of all hulls first.
void nameHullFiles(RobotResult& result);

/// The name of the ROS package that a robot's output is.
std::string outputPackage(const std::string& robot_name);

/// Where the rewritten description lies in the output folder.
std::string urdfFile(const std::string& robot_name);

/// The description with a <collision> for every hull. A link with a failed mesh keeps what it has.
std::string rewrittenDescription(const RobotDescription& robot, const RobotResult& result, const std::string& output);

/// What the user of the rewritten description should know: meshes that it still names relative to the old one's place.
std::vector<std::string> notesOnRewritten(const RobotResult& result, const std::string& output);

}  // namespace collision_hulls
