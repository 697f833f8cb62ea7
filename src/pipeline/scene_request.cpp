// What a robot is fitted to, read from the files and texts that a user gives.
#include <utility>

#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/fit_scene.h"

namespace collision_hulls {

SceneRequest readSceneRequest(const Input& input, const SceneSources& sources, const RunControl& control) {
  if (sources.max_step != 0 && sources.configurations.empty())
    throw Error(ErrorCode::kBadOption,
                "max-step '" + decimal(sources.max_step) +
                    "' interpolates between given configurations, and none are given; add configurations, or omit max-step");
  SceneRequest request;
  for (const std::string& file : {sources.scene, sources.srdf_file, sources.configurations})
    if (!file.empty()) request.files.push_back(file);
  if (!sources.scene.empty())
    request.scene = readScene(sources.scene, input.find_package, sources.mesh_limits, control, sources.package_path);
  request.files.insert(request.files.end(), request.scene.files.begin(), request.scene.files.end());
  if (!sources.srdf.empty() || !sources.srdf_file.empty()) {
    DisabledPairs disabled = parseDisabledPairs(sources.srdf, input.robot, sources.srdf_file, control);
    request.disabled = std::move(disabled.pairs);
    request.notes = std::move(disabled.notes);
  }
  if (!sources.configurations.empty()) {
    const ConfigurationOptions options = givenConfigurations(sources.max_step);
    giveConfigurations(readConfigurations(sources.configurations, Kinematics(input.robot), options, control), request);
  }
  return request;
}

ConfigurationOptions givenConfigurations(double max_step) {
  ConfigurationOptions options;
  options.max_step = max_step;
  options.refuse_beyond_limits = true;
  return options;
}

void giveConfigurations(ConfigurationSet given, SceneRequest& request) {
  request.configurations = std::move(given.configurations);
  request.notes.insert(request.notes.end(), given.notes.begin(), given.notes.end());
}

}  // namespace collision_hulls
