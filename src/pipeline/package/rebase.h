// Relative file names of a description that gets another place.
#pragma once

#include <map>
#include <set>
#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

struct RebasedDescription {
  RobotDescription robot;      ///< of the same path; its text differs in those file names alone
  std::string base;            ///< the file that its relative URIs count from
  std::set<std::string> uris;  ///< the new ones
};

/// With Options::rebase, the description with relative URIs of meshes and textures that lead to the same files from `new_file`, in the
/// style of Options::uri; with UriStyle::kPackage those of files in no package that is known become file://. URIs whose file is not found,
/// or may not be read, stay; so do those of <collision> elements that `moved` has, for rewriteCollisions(). Without it, the description as
/// it is. Throws kCancelled.
RebasedDescription rebased(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                           const std::string& new_file, const std::map<std::string, std::string>& moved, const RunControl& control);

}  // namespace collision_hulls
