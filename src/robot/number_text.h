// Numbers as text, whatever the locale of the program.
#pragma once

#include <Eigen/Core>
#include <string>

namespace collision_hulls {

/// The shortest decimal text that reads back as exactly `value` (finite), with a point and without an exponent; "0" for -0.
std::string numberText(double value);

/// The three coordinates, separated by spaces.
std::string vectorText(const Eigen::Vector3d& vector);

}  // namespace collision_hulls
