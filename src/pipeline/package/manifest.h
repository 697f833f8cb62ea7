// What makes a folder with a description a package of ROS.
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// package.xml: of the maintainers of the package that the input lies in, if it says who they are; it depends on the packages that the
/// descriptions name files of. Throws kCancelled.
std::string packageXml(const std::string& package, const RobotResult& result, const RunControl& control = {});

/// CMakeLists.txt, which lets the package lie in the source folder of a workspace.
std::string cmakeLists(const std::string& package, const RobotResult& result);

}  // namespace collision_hulls
