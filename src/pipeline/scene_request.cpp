// What a robot is fitted to, read from the files and texts that a user gives.
#include <utility>

#include "base/decimal.h"
#include "base/finite_number.h"
#include "base/uri_text.h"
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

std::map<std::string, double> jointPositions(const std::vector<std::string>& texts, const std::string& option) {
  std::map<std::string, double> positions;
  for (const std::string& text : texts) {
    const std::size_t equals = text.rfind('=');
    double value = 0;
    if (equals == std::string::npos || equals == 0 || !parseFinite(text.substr(equals + 1), value))
      throw Error(ErrorCode::kBadOption,
                  option + " '" + shown(text) + "' is invalid: use a joint and a value in rad or m, as in elbow=1.5");
    if (!positions.emplace(text.substr(0, equals), value).second)
      throw Error(ErrorCode::kBadOption,
                  option + " '" + shown(text) + "': joint '" + text.substr(0, equals) + "' has a position already; omit one of them");
  }
  return positions;
}

void giveConfigurations(ConfigurationSet given, SceneRequest& request) {
  request.configurations = std::move(given.configurations);
  request.notes.insert(request.notes.end(), given.notes.begin(), given.notes.end());
}

}  // namespace collision_hulls
