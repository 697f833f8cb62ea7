// From hulls to the collision model of a robot: file names, URIs, and the rewritten description.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// The name of the ROS package that a robot's output becomes: the one that the options give, or else that of its folder, made legal.
std::string outputPackage(const Options& options, const std::string& output);

/// What the URIs of a description refer to: the name of its package, or its folder.
std::string placeOfUris(const Options& options, const std::string& output);

/// Where the rewritten description lies in the output folder. `model`: of models beside the first.
std::string urdfFile(const std::string& robot_name, const std::string& model = "");

/// Rewrites the description with a <collision> for every hull, once for each model; a link with a failed mesh keeps what it has. Hulls of
/// earlier outputs that it keeps go along into the new one (result.kept_files). Adds to the report's notes: the oddities of the description
/// and of the search for its files, `notes`, and what the user of the new description should know, such as URIs relative to the old one's
/// place.
void rewriteDescription(const RobotDescription& robot, const std::vector<LinkDecisions>& decisions, const PackageFinder& find_package,
                        const std::string& output, const std::vector<std::string>& notes, RobotResult& result, const RunControl& control);

}  // namespace collision_hulls
