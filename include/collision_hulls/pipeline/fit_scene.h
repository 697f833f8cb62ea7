// Fits a robot's collision model to a scene: reads its meshes, builds their hull trees or takes
// them from the cache, finds the cut that the scene needs, and certifies it.
//
// For example:
//
//     #include "collision_hulls/pipeline/output.h"
//
//     const Input input = openInput("arm.urdf");
//     SceneSources sources;
//     sources.scene = "kitchen.yaml";
//     SceneRequest request = readSceneRequest(input, sources);
//     request.clearance = 0.02;  // [m]
//     const std::string output = "arm_in_kitchen";
//     RobotResult result =
//         fitRobotToScene(input.robot, input.find_package, request, Options(), output);
//     std::cout << result.report.scene->hulls << " hulls\n";
//     writeOutput(result, output);
#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_hulls/fit/fit.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/scene/configurations.h"

namespace collision_hulls {

/// What to fit a robot to.
struct SceneRequest {
  Scene scene;
  double clearance = 0.01;                  ///< [m]
  std::size_t samples = 10000;              ///< per verification batch
  bool compare = false, primitives = true;  ///< see FitOptions
  std::vector<DisabledPair> disabled;       ///< pairs of links that are not checked; a note names
                                            ///< one whose links the robot does not have
  /// The joints that move: a regular expression that matches whole names; empty: all. The others
  /// stay at rest.
  std::string joints;
  std::map<std::string, double> at;           ///< [rad or m] where these joints stay, by name
  std::vector<std::string> notes;             ///< about what was read, for the report
  std::vector<Configuration> configurations;  ///< instead of samples from the joints' whole ranges
  std::vector<std::string> files;             ///< that it was read from: no output may replace them
};

/// Where a request is read from; what is empty is not given.
struct SceneSources {
  std::string scene;           ///< file
  std::string srdf;            ///< text
  std::string srdf_file;       ///< the file that the text is from, for messages
  std::string configurations;  ///< file
  double max_step = 0;         ///< [rad or m] between configurations, see ConfigurationOptions
  MeshLimits mesh_limits;      ///< for the scene's meshes
  std::vector<std::string>
      package_path;  ///< where a scene's xacro finds packages, see readRobotDescription()
};

/// What the options let the reading of a mesh use: reader_memory and reader_time.
MeshLimits meshLimits(const Options& options);

/// Reads a request from its sources. Throws the readers' errors, and kBadOption for a step without
/// configurations.
SceneRequest readSceneRequest(const Input& input, const SceneSources& sources,
                              const RunControl& control = {});

/// How to read configurations for a request: values beyond the joint limits are refused, since
/// nothing is proved there.
ConfigurationOptions givenConfigurations(double max_step);

/// From texts such as "elbow=1.5" [rad or m], for SceneRequest::at. `option`: what messages call
/// them. Throws kBadOption for another form, and a joint that has two positions.
std::map<std::string, double> jointPositions(const std::vector<std::string>& texts,
                                             const std::string& option);

/// Adds configurations to a request, with the notes about them.
void giveConfigurations(ConfigurationSet given, SceneRequest& request);

/// Like decomposeRobot(), with hulls as fine as the scene needs but no finer than the options'
/// tolerance; report.scene says why. A tree that the cache holds for the same tolerance needs no
/// decomposition. Links that `options.links` does not select, that the options keep, or that have a
/// mesh that failed take part with their collision elements; where one of these cannot be read,
/// all of that link's are absent, and a note says so. `method` must be certified. extra_files holds
/// `config/<robot>_disabled.srdf`; where joints are held, that says nothing of pairs that always or
/// never meet. Throws kBadOption, also for configurations of another size or with values that are
/// not finite, for joints that the robot does not have or that leave nothing to move, for
/// configurations where joints are held, and where no mesh is left to fit; kNotARobot as
/// Kinematics; kUnwritableOutput, kTooLarge, kInternal and kCancelled as decomposeRobot();
/// kTooLarge as fitScene().
RobotResult fitRobotToScene(const RobotDescription& robot, const PackageFinder& find_package,
                            const SceneRequest& request, const Options& options,
                            const std::string& output, const RunControl& control = {},
                            const StepCallback& step = {});

}  // namespace collision_hulls
