// Robots through DART's URDF loader.
#pragma once

#include <dart/dynamics/Skeleton.hpp>
#include <string>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The robot of a description, with its collision models as triangle meshes. Its `<visual>` elements are left out: collisions need none,
/// and DART ends the process for those whose scale mirrors. Throws kNotARobot where DART's loader fails.
dart::dynamics::SkeletonPtr loadRobot(const std::string& urdf, const std::string& path, const PackageFinder& find_package);

}  // namespace collision_hulls
