// File names of a description that nobody could follow from its new place.
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

/// Whether a URI names a package that is not known, and yet leads to a file, in a folder that stands in for the package.
bool leadsToStandIn(const std::string& uri, const std::string& base, const PackageFinder& find_package);

/// With Options::rebase, the description with URIs of meshes and textures, those that are relative or lead to a stand-in, that lead to the
/// same files from `new_file`, in the style of Options::uri; with UriStyle::kPackage those of files in no package that is known become
/// file://. URIs whose file is not found, or may not be read, stay; so do those of <collision> elements that `moved` has, for
/// rewriteCollisions(). Without it, the description as it is. Throws kCancelled.
RebasedDescription rebased(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                           const std::string& new_file, const std::map<std::string, std::string>& moved, const RunControl& control);

}  // namespace collision_hulls
