// The largest length of an option: hulls that protrude further, or solids that were closed further, no longer resemble a robot.
#pragma once

#include <string>

namespace collision_hulls {

constexpr double kLargestTolerance = 1;  // [m]

/// Throws kBadOption for a length in metres above that: 5 for 5 mm is the usual mistake. `text`: as it was given, with or without a unit,
/// or in metres, if that is no longer known; `otherwise`: a sentence on what else helps.
void expectUnit(const std::string& option, const std::string& text, double metres, bool has_unit, const std::string& otherwise = "");

}  // namespace collision_hulls
