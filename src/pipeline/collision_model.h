// From hulls to the collision model of a robot: file names, URIs, and the rewritten description.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// The name of the ROS package that a robot's output becomes: the one that the options give, or else that of its folder, made legal.
std::string outputPackage(const Options& options, const std::string& output);

/// Where the rewritten description lies in the output folder.
std::string urdfFile(const std::string& robot_name);

/// Rewrites the description with a <collision> for every hull; a link with a failed mesh keeps what it has. Hulls of earlier outputs
/// that it keeps go along into the new one (result.kept_files). Adds to the report's notes: the oddities of the description and of the
/// search for its files, `notes`, and what the user of the new description should know, such as URIs relative to the old one's place.
void rewriteDescription(const RobotDescription& robot, const PackageFinder& find_package, const std::string& output,
                        const std::vector<std::string>& notes, RobotResult& result);

}  // namespace collision_hulls
