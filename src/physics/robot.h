// Loads robots with DART's URDF loader.
#pragma once

#include <dart/dynamics/Skeleton.hpp>
#include <string>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The robot of a description, with its collision models as triangle meshes. `<visual>` elements are dropped: collisions do not need them,
/// and DART aborts the process for visuals with a mirroring scale. Throws kNotARobot if DART's loader fails.
dart::dynamics::SkeletonPtr loadRobot(const std::string& urdf, const std::string& path, const PackageFinder& find_package);

}  // namespace collision_hulls
