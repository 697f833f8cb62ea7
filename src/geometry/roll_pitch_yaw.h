// Rotations as URDF and SDF write them: by roll, pitch and yaw [rad] about the fixed axes x, y and z, roll first.
#pragma once

#include <Eigen/Geometry>

namespace collision_hulls {

Eigen::Quaterniond fromRollPitchYaw(const Eigen::Vector3d& rpy);

/// Of a rotation. At pitch = +-pi/2, where only the sum of the other two is determined, any pair that gives the rotation back.
Eigen::Vector3d rollPitchYaw(const Eigen::Matrix3d& rotation);

}  // namespace collision_hulls
