// fit_scene INPUT --scene FILE --clearance LENGTH: makes a robot's collision model that is no finer than a scene needs.
#include "collision_hulls/pipeline/fit_scene.h"

#include <filesystem>
#include <system_error>

#include "base/in_context.h"
#include "robot_program.h"
#include "storage/csv.h"
#include "storage/files.h"
#include "storage/text_file.h"

namespace collision_hulls {
namespace {

constexpr const char* kComparisonHeader =
    "robot,scene,clearance,model,tolerance,hulls,hull_vertices,samples,clear,phantom,free,false_hits,missed,collision_us,tree_us,close_us,"
    "distance_us,seconds";

std::string comparisonCsv(const std::string& robot, const FitReport& fit) {
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

constexpr const char* kFooter = R"(
Wherever the original robot keeps the clearance from the scene and from itself, the model should be free of collisions, too; and it
never misses a collision. The report says what each link needed, what is proved, and gives an upper bound on the share of
configurations in which the model still collides although the original keeps the clearance.

The model is of certified hulls. The options of decompose that this leaves no room for are refused, with a reason each: other methods,
--padding, --scale, --segments, --shapes, --spheres, --time-limit, --tree and --for curobo. There is no --model: a scene decides on the
detail.

Exit status: as for decompose.

Examples:
  fit_scene arm.urdf --scene kitchen.scene --clearance 2cm
  fit_scene ur_description --scene cell.yaml --clearance 1cm --configurations path.csv --srdf ur.srdf)";

struct SceneCommand {
  RobotCommand robot;
  std::string scene, clearance, configurations, srdf, compare;
  double clearance_metres = 0;  // once it is known
  int samples = 10000;
  double max_step = 0;
  bool hulls_only = false;
};

void addOptions(CommandLine& app, SceneCommand& command) {
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
  addFile("--srdf", command.srdf, "SRDF whose disabled pairs of links are not checked");
  app.add_flag("--hulls-only", command.hulls_only, "Use no spheres, boxes or cylinders in place of hulls")->group("Scene");
  addFile("--compare", command.compare, "Also measure single hulls and uniform tolerances, and write the comparison to this CSV");
  addRobotOptions(app, "A ROS package, or a .urdf or .xacro file", command.robot);
  app.hide({"method", "padding", "scale", "segments", "shapes", "spheres", "time-limit", "tree"});
}

/// Refuses what would ask for an option that is refused here in turn.
void refuseForDecompose(const RobotCommand& command) {
  if (command.given.names.count("segments") > 0)
    throw Error(ErrorCode::kBadOption, "--segments shows clusters of method 'hacd', which builds no hull tree to fit; use decompose");
  for (const std::string& name : command.consumer_names)
    if (name == collision_hulls::name(Consumer::kCurobo))
      throw Error(ErrorCode::kBadOption, "--for curobo needs a model of spheres alone, which is not fitted to a scene; use decompose");
}

/// Checks what needs no file, so that nothing is read in vain.
void interpret(SceneCommand& command) {
  refuseForDecompose(command.robot);
  if (command.samples <= 0)
    throw Error(ErrorCode::kBadOption, "--samples '" + std::to_string(command.samples) + "' is not understood: it takes a number above 0");
  command.clearance_metres = parseMetres(command.clearance, "--clearance");
  check(FitOptions{command.clearance_metres, static_cast<std::size_t>(command.samples)});
  if (command.compare == "-")
    throw Error(ErrorCode::kBadOption, "--compare '-': the comparison cannot go to standard output, which has the table; give a file");
}

/// Refuses a file that cannot be written, that holds something else than a comparison, or that the report goes to.
void checkComparison(SceneCommand& command, const std::string& output) {
  command.compare = writablePath(command.compare);
  checkBeside(command.compare, output);
  checkBeginsWith(command.compare, kComparisonHeader, "comparison");
  std::error_code none;
  const bool is_special = std::filesystem::exists(command.compare, none) && !std::filesystem::is_regular_file(command.compare, none);
  if (isFile(command.robot.json) && !is_special && liesWithin(command.compare, command.robot.json))
    throw Error(ErrorCode::kBadOption, "'" + command.compare + "' is also the file of --json; choose another name");
}

SceneRequest requestOf(const SceneCommand& command, const Input& input, const RunControl& control) {
  if (input.kind != Input::Kind::kRobot)
    throw Error(ErrorCode::kBadOption,
                "'" + input.path + "' is a mesh; only a robot can be fitted to a scene, so give a URDF, xacro file or package");
  const std::string srdf = command.srdf.empty() ? "" : readTextFileOrPipe(command.srdf, ".srdf file", control);
  SceneRequest request = readSceneRequest(input,
                                          {command.scene, srdf, command.srdf, command.configurations, command.max_step,
                                           meshLimits(command.robot.options), command.robot.package_path},
                                          control);
  request.clearance = command.clearance_metres;
  request.samples = static_cast<std::size_t>(command.samples);
  request.compare = !command.compare.empty();
  request.primitives = !command.hulls_only;
  return request;
}

int main(int argc, char** argv) {
  SceneCommand command;
  command.robot.program = "fit_scene";
  CommandLine app("Makes a robot's collision model that is no finer than a scene needs.", command.robot.program);
  app.footer(kFooter);
  addOptions(app, command);
  std::string comparison;
  const RobotWork work = [&](const Input& input, const std::string& output, const RunControl& control, const StepCallback& step) {
    if (!command.compare.empty()) inContext("--compare", [&] { checkComparison(command, output); });
    const SceneRequest request = requestOf(command, input, control);
    RobotResult result = fitRobotToScene(input.robot, input.find_package, request, command.robot.options, output, control, step);
    if (request.compare && result.report.scene) comparison = comparisonCsv(result.robot_name, *result.report.scene);
    return result;
  };
  return runTerminalProgram(app, argc, argv, [&] {
    interpret(command);
    const int status = runRobotCommand(command.robot, work);
    if (!comparison.empty()) writeNamedFile(command.compare, comparison);  // last, so that the model is written even if this fails
    return status;
  });
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  return collision_hulls::main(argc, argv);
}
