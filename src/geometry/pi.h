// Pi: C++17 has no constant for it.
#pragma once

namespace collision_hulls {

constexpr double kPi = 3.14159265358979323846;

}  // namespace collision_hulls
