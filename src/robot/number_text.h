// Numbers as text, whatever the locale of the program.
#pragma once

#include <Eigen/Core>
#include <string>

namespace collision_hulls {

/// The shortest decimal text that reads back as exactly `value` (finite), with a point and without an exponent; "0" for -0.
std::string numberText(double value);

/// The three coordinates, separated by spaces.
std::string vectorText(const Eigen::Vector3d& vector);

/// Roll, pitch and yaw (fixed axes, yaw * pitch * roll) of a rotation [rad]. At pitch = +-pi/2, where only the sum of the
/// other two is determined, any pair that gives the rotation back.
Eigen::Vector3d rollPitchYaw(const Eigen::Matrix3d& rotation);

}  // namespace collision_hulls
