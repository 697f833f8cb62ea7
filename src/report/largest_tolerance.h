// The largest length of an option: hulls that protrude further, or solids that were closed further, no longer resemble a robot.
#pragma once

#include <string>

namespace collision_hulls {

constexpr double kLargestTolerance = 1;  // [m]

/// Throws kBadOption for a length in metres above that: 5 for 5 mm is the usual mistake.
void expectUnit(const std::string& option, double metres);

}  // namespace collision_hulls
