// What fit_scene takes, checks and makes, whoever calls: a terminal or Python.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "base/in_context.h"
#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "collision_hulls/robot/kinematics.h"
#include "file_options.h"
#include "pipeline/scene/fit_refusals.h"
#include "pipeline/scene/held_joints.h"
#include "robot_command.h"
#include "storage/csv.h"
#include "storage/files.h"
#include "storage/text_file.h"

namespace collision_hulls {

/// The command line of such a program.
struct SceneCommand {
  RobotCommand robot;
  std::string scene, clearance, configurations, joints, srdf, compare;
  std::vector<std::string> at;
  std::string srdf_text;  // once it is known, as what follows
  double clearance_metres = 0;
  std::map<std::string, double> positions;  // of `at`
  int samples = 10000;
  double max_step = 0;
  bool hulls_only = false;
  std::string comparison;  // what goes to `compare`, once it is known
};

constexpr const char* kComparisonHeader =
    "robot,scene,clearance,model,tolerance,hulls,hull_vertices,samples,clear,phantom,free,false_hits,missed,collision_us,tree_us,close_us,"
    "distance_us,seconds";

inline std::string comparisonCsv(const std::string& robot, const FitReport& fit) {
  std::string text = std::string(kComparisonHeader) + "\n";
  const auto count = [](std::size_t n) { return std::to_string(n); };
  for (const ModelRow& row : fit.models) {
    text += csvLine({robot, fit.scene, csvNumber(fit.clearance), row.model, csvNumber(row.tolerance), count(row.hulls), count(row.vertices),
                     count(fit.samples), count(row.clear), count(row.phantom), count(row.free), count(row.false_hits), count(row.missed),
                     csvNumber(row.collision_us), csvNumber(row.tree_us), csvNumber(row.close_us), csvNumber(row.distance_us),
                     csvNumber(fit.seconds)});
  }
  return text;
}

inline void addSceneOptions(CommandLine& app, SceneCommand& command) {
  const auto add = [&](const std::string& name, auto& value, const std::string& type, const std::string& help) {
    return app.add_option(name, value, help)->type_name(type)->group("Scene");
  };
  const auto addFile = [&](const std::string& name, std::string& file, const std::string& help) {
    return add(name, file, "FILE", help)->check(notEmpty("a file"));
  };
  addFile("--scene", command.scene,
          "The robot's surroundings: .scene (MoveIt), .urdf, .xacro, .sdf, .world, .yaml, .bt or .ot (OctoMap), or a mesh")
      ->required();
  add("--clearance", command.clearance, "LENGTH", "The model must be free wherever the robot keeps this distance: 2cm, 0.02")->required();
  add("--samples", command.samples, "N [10000]", "Fresh configurations to verify the model with");
  addFile("--configurations", command.configurations, "Fit to these configurations only: .csv, or .yaml of joint states or a trajectory");
  add("--max-step", command.max_step, "STEP",
      "Interpolate between the given configurations so that no joint moves more than STEP [rad or m]");
  add("--joints", command.joints, "REGEX",
      "Only these joints move; the others stay at rest, or where --at says: a regular expression that matches whole names")
      ->check(notEmpty("a regular expression"));
  add("--at", command.at, "JOINT=VALUE", "A joint that stays at this position [rad or m]; repeatable");
  addFile("--srdf", command.srdf, "SRDF whose disabled pairs of links are not checked");
  app.add_flag("--hulls-only", command.hulls_only, "Use no spheres, boxes or cylinders in place of hulls")->group("Scene");
  addFile("--compare", command.compare, "Also measure single hulls and uniform tolerances, and write the comparison to this CSV");
  addRobotOptions(app, "A ROS package, or a .urdf or .xacro file", command.robot);
  app.hide({"method", "padding", "scale", "segments", "shapes", "spheres", "time-limit", "tree"});
}

/// Refuses what would ask for an option that is refused here in turn.
inline void refuseForDecompose(const RobotCommand& command) {
  if (command.given.names.count("segments") > 0)
    throw Error(ErrorCode::kBadOption, "--segments shows clusters of method 'hacd', which builds no hull tree to fit; use decompose");
  for (const std::string& name : command.consumer_names)
    if (name == collision_hulls::name(Consumer::kCurobo))
      throw Error(ErrorCode::kBadOption, "--for curobo needs a model of spheres alone, which is not fitted to a scene; use decompose");
}

/// Refuses a file that cannot be written, that holds something else than a comparison, or that the report goes to.
inline void checkComparison(SceneCommand& command, const std::string& output) {
  command.compare = writablePath(command.compare);
  checkBeside(command.compare, output);
  expectFolderOf(command.compare);
  checkBeginsWith(command.compare, kComparisonHeader, "comparison");
  std::error_code none;
  const bool is_special = std::filesystem::exists(command.compare, none) && !std::filesystem::is_regular_file(command.compare, none);
  if (isFile(command.robot.json) && !is_special && liesWithin(command.compare, command.robot.json))
    throw Error(ErrorCode::kBadOption, "'" + command.compare + "' is also the file of --json; choose another name");
}

/// Checks what the robot and the output decide, and reads the SRDF.
inline void refuseBeforeMeshes(SceneCommand& command, const Input& input, const std::string& output, const RunControl& control) {
  if (input.kind != Input::Kind::kRobot)
    throw Error(ErrorCode::kBadOption,
                "'" + input.path + "' is a mesh; only a robot can be fitted to a scene, so give a URDF, xacro file or package");
  if (!command.compare.empty()) inContext("--compare", [&] { checkComparison(command, output); });
  const Options& options = command.robot.options;
  refuseOtherWays(input.robot, options, LinkDecisions(options, input.robot, control));
  checkClearance(command.clearance_metres, input.robot);
  heldJoints(Kinematics(input.robot), command.joints, command.positions);
  if (!command.srdf.empty()) command.srdf_text = readTextFileOrPipe(command.srdf, ".srdf file", control);
}

/// Checks what needs no file, so that nothing is read in vain, and prepares the checks of what does. `command` must not move from here on.
inline void interpret(SceneCommand& command) {
  refuseForDecompose(command.robot);
  if (command.samples <= 0)
    throw Error(ErrorCode::kBadOption, "--samples '" + std::to_string(command.samples) + "' is not understood: it takes a number above 0");
  command.clearance_metres = parseMetres(command.clearance, "--clearance");
  command.positions = jointPositions(command.at, "--at");
  check(FitOptions{command.clearance_metres, static_cast<std::size_t>(command.samples)});
  if (command.compare == "-")
    throw Error(ErrorCode::kBadOption, "--compare '-': the comparison cannot go to standard output, which has the table; give a file");
  command.robot.refuse_early = [&command](const Input& input, const std::string& output, const RunControl& control) {
    refuseBeforeMeshes(command, input, output, control);
  };
}

inline SceneRequest requestOf(const SceneCommand& command, const Input& input, const RunControl& control) {
  SceneRequest request = readSceneRequest(input,
                                          {command.scene, command.srdf_text, command.srdf, command.configurations, command.max_step,
                                           meshLimits(command.robot.options), command.robot.package_path},
                                          control);
  request.clearance = command.clearance_metres;
  request.samples = static_cast<std::size_t>(command.samples);
  request.compare = !command.compare.empty();
  request.primitives = !command.hulls_only;
  request.joints = command.joints;
  request.at = command.positions;
  return request;
}

/// Fits, for a command that was interpreted. `command` must outlive it.
inline RobotWork fitting(SceneCommand& command) {
  return [&command](const Input& input, const std::string& output, const RunControl& control, const StepCallback& step) {
    const SceneRequest request = requestOf(command, input, control);
    RobotResult result = fitRobotToScene(input.robot, input.find_package, request, command.robot.options, output, control, step);
    if (request.compare && result.report.scene) command.comparison = comparisonCsv(result.robot_name, *result.report.scene);
    return result;
  };
}

/// Writes the comparison, if there is one: last, so that the model is written even if this fails.
inline void writeComparison(const SceneCommand& command) {
  if (!command.comparison.empty()) writeNamedFile(command.compare, command.comparison);
}

}  // namespace collision_hulls
