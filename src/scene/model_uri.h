// Where SDF's model:// URIs lead.
#pragma once

#include <string>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The file or folder that a URI of an SDF file means: resolveUri(), and model://NAME/... in the folders of GAZEBO_MODEL_PATH,
/// GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH and SDF_PATH, in those that enclose `base` (a file), as a package's name, and in
/// ~/.gazebo/models. Throws kPackageNotFound where none of them has it, and kUnsupportedFormat for a URI on the web.
std::string resolveModelUri(const std::string& uri, const std::string& base, const PackageFinder& find_package);

}  // namespace collision_hulls
