// What a user should know of the number of hulls, with the remedy.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// Whether a row has the hulls that a tolerance asked for.
bool followsTolerance(const ElementReport& row);

/// On meshes that took more hulls than they may need, for the likeliest reason of each: one note for all meshes with the same reason. And
/// on the number of hulls of the whole robot.
std::vector<std::string> notesOnHulls(const RobotResult& result, const RunControl& control = {});

}  // namespace collision_hulls
