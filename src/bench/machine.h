// Describes the machine on which a measurement was taken, which is needed to compare it with another.
#pragma once

#include <nlohmann/json.hpp>

namespace collision_hulls {

/// "system", "cpu", "cores", "memory_mb", "build" (compiler and kind), "libraries", "collision_hulls" (version).
nlohmann::json describeMachine();

}  // namespace collision_hulls
