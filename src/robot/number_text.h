// Numbers as text, whatever the locale of the program.
#pragma once

#include <Eigen/Core>
#include <string>

namespace collision_hulls {

/// The shortest decimal text that reads back as exactly `value`, with a point and without an exponent; "0" for -0. Throws kBadOption unless
/// it is finite.
std::string numberText(double value);

/// The three coordinates, separated by spaces.
std::string vectorText(const Eigen::Vector3d& vector);

}  // namespace collision_hulls
