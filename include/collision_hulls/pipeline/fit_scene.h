// A robot's collision model for a scene: its meshes read, their hull trees made or remembered, the cut that the scene needs, certified.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/scene/configurations.h"
#include "collision_hulls/scene/fit.h"

namespace collision_hulls {

/// What a robot is fitted to.
struct SceneRequest {
  Scene scene;
  double clearance = 0.01;                    ///< [m]
  std::size_t samples = 10000;                ///< that verify
  bool compare = false, primitives = true;    ///< see FitOptions
  std::vector<DisabledPair> disabled;         ///< pairs of links that are not looked at
  std::vector<std::string> notes;             ///< on what was read, for the report
  std::vector<Configuration> configurations;  ///< instead of samples of all that the joints allow
};

/// What a request is read from; empty: not.
struct SceneSources {
  std::string scene;           ///< file
  std::string srdf;            ///< text
  std::string srdf_file;       ///< that it comes from, for messages
  std::string configurations;  ///< file
  double max_step = 0;         ///< [rad or m] between configurations, see ConfigurationOptions
};

/// Reads what is asked for. Throws the readers' errors, and kBadOption for a step where no configurations are given.
SceneRequest readSceneRequest(const Input& input, const SceneSources& sources);

/// How configurations are to be read that are given to a request: beyond the joints' limits nothing is proved, so that they are refused.
ConfigurationOptions givenConfigurations(double max_step);

/// Gives them to a request, with the notes on them.
void giveConfigurations(ConfigurationSet given, SceneRequest& request);

/// As decomposeRobot(), with hulls as fine as the scene asks for, and no finer than the options' tolerance: report.scene says why. What
/// the cache has of trees costs no decomposition, at the same tolerance. Links that `options.links` does not choose, and those with a mesh
/// that failed, are not there in the scene. `method` has to be certified.
/// extra_files has `config/<robot>_disabled.srdf`. Throws kBadOption, kCancelled.
RobotResult fitRobotToScene(const RobotDescription& robot, const PackageFinder& find_package, const SceneRequest& request,
                            const Options& options, const std::string& output, const RunControl& control = {},
                            const StepCallback& step = {});

}  // namespace collision_hulls
