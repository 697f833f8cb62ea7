// Resolves SDF's model:// URIs.
#pragma once

#include <string>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The file or folder that a URI in an SDF file refers to. model://NAME/... is searched for in the folders of GAZEBO_MODEL_PATH,
/// GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH and SDF_PATH, in the folders above `base` (a file) and their subfolders `models`, in
/// ~/.gazebo/models, and then as package NAME; any other URI goes to resolveUri(). Throws kPackageNotFound if none of these has it, and
/// kUnsupportedFormat for a URI on the web.
std::string resolveModelUri(const std::string& uri, const std::string& base, const PackageFinder& find_package);

}  // namespace collision_hulls
