// What a user should know of a fit to a scene beside its figures: one sentence each, with the remedy.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "collision_hulls/fit/fit.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"
#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// [m] How far from the root the joints can take a link's frame, all stretched out.
double reachOf(const RobotDescription& robot);

/// On false collisions that only max-hulls keeps; empty: there are none. `capped`: the links with a mesh that finer hulls would fit.
std::string noteOnCap(const FitReport& fit, const std::set<std::string>& capped);

/// On what was fitted.
std::vector<std::string> notesOnFit(const FitReport& fit, const Options& options);

/// On a model that takes longer to query than the meshes that it stands for; empty: it does not.
std::string noteOnSpeed(const FitReport& fit, const Scene& scene);

/// On pairs that are not to be checked, of links that the robot does not have; empty: there are none.
std::string noteOnUnknownPairs(const std::vector<DisabledPair>& disabled, const RobotDescription& robot);

/// On a scene of which nothing comes near the robot: one in millimetres is a thousand times too far away.
std::vector<std::string> notesOnFarScene(const Scene& scene, double clearance, const RobotDescription& robot);

}  // namespace collision_hulls
