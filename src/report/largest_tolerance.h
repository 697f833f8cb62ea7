// The largest length of an option: hulls that protrude further, or solids that were closed further, no longer resemble a robot.
#pragma once

namespace collision_hulls {

constexpr double kLargestTolerance = 1;  // [m]

}  // namespace collision_hulls
