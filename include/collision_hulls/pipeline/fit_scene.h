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

/// Reads what is asked for, where it is not empty: a file with a scene, an SRDF's text, and a file with configurations. Throws the readers'
/// errors, which name `srdf_file` where the SRDF comes from one.
SceneRequest readSceneRequest(const Input& input, const std::string& scene, const std::string& srdf, const std::string& configurations,
                              const std::string& srdf_file = "");

/// How configurations are to be read that are given to a request: beyond the joints' limits nothing is proved, so that they are refused.
ConfigurationOptions givenConfigurations();

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
