// Where a measurement was taken: what has to be known to compare it with another.
#pragma once

#include <nlohmann/json.hpp>

namespace collision_hulls {

/// "system", "cpu", "cores", "memory_mb", "build" (compiler and kind), "libraries", "collision_hulls" (version).
nlohmann::json describeMachine();

}  // namespace collision_hulls
