// plan_benchmark ROBOT --scene FILE: how much time a planner needs with the original meshes, and with models that take their place.
#include "planning/plan_benchmark.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "decompose_options.h"
#include "list_options.h"
#include "measuring_program.h"
#include "planning/plan_table.h"
#include "storage/csv.h"
#include "storage/files.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

struct Command {
  std::string robot, output, models, checkers, clearance, tolerance;
  std::vector<std::string> scenes, package_path, at;
  int queries = 50, samples = 10000, seed = 1;
  PlanOptions options;
};

constexpr const char* kPurpose =
    "Shows what a planner gains by a collision model: OMPL's RRT-Connect with the original meshes and with models.";

constexpr const char* kFooter = R"(
Starts and goals are random states that are free with the original meshes, while the straight motion between them is not; they are the
same for all models. A model that finds one of them in
collision has lost that query. Each found path is looked at again with the original meshes, at a tenth of the planner's step.

Writes queries.csv, a row for each query and model, and plan.json, a summary. plan_charts runs this for several robots and draws charts.

Exit status: 0 done, however many queries were solved; 2 usage error or unreadable input.

Example:
  plan_benchmark urdf/demo_arm.urdf --scene urdf/demo_shelf.yaml -o out)";

void addOptions(CommandLine& app, Command& command) {
  PlanOptions& options = command.options;
  const auto add = [&](const std::string& name, auto& value, const std::string& type, const std::string& help) {
    return app.add_option(name, value, help)->type_name(type);
  };
  add("ROBOT", command.robot, "", "A ROS package, or a .urdf or .xacro file")->required();
  add("--scene", command.scenes, "FILE", "What stands around the robot, as for fit_scene; repeatable")->required();
  add("-o,--output", command.output, "DIR", "Output folder; files of an earlier run there are replaced")
      ->required()
      ->check(notEmpty("a folder"));
  add("--queries", command.queries, "N [50]", "Queries a scene")->check(range(1, 1e6));
  add("--joints", options.joints, "REGEX", "Joints that are planned: a regular expression that matches the whole name; default: all");
  add("--at", command.at, "JOINT=VALUE", "Position of a joint that is not planned [rad or m]; repeatable; default: at rest");
  add("--models", command.models, "LIST",
      "Models, comma-separated, original first: original,single_hull,default,fitted,spheres; default: all");
  add("--checkers", command.checkers, "LIST",
      "Comma-separated: boxes, this package's own; trees, FCL's dynamic trees; moveit, the same with hulls as meshes; default: all");
  add("--time-limit", options.planner.time_limit, "S [5]", "Time per query, in seconds")->check(range(1e-3, 3600));
  add("--step", options.planner.step, "SHARE [0.005]", "Share of a joint's range between states at which a motion is checked")
      ->check(range(1e-5, 0.5));
  add("-t,--tolerance", command.tolerance, "LENGTH [1cm,5%]", "Tolerance of all models but original and single_hull");
  add("--clearance", command.clearance, "LENGTH [1cm]", "Clearance of the model that is fitted to the scene");
  add("--samples", command.samples, "N [10000]", "Configurations that verify the fitted model")->check(range(1, 1e9));
  add("--seed", command.seed, "N [1]", "Seed of queries and planner")->check(range(1, 1e9));
  addPackagePath(app, command.package_path);
}

void interpret(Command& command) {
  PlanOptions& options = command.options;
  options.queries = static_cast<std::size_t>(command.queries);
  options.seed = static_cast<std::uint32_t>(command.seed);
  options.request.samples = static_cast<std::size_t>(command.samples);
  options.request.options.validate = false;
  const auto same = [](const std::string& text) { return text; };
  const auto checker = [](const std::string& text) { return choice("--checkers", text, checkerNamed, "boxes, trees, moveit"); };
  if (!command.models.empty()) options.models = parsedList<std::string>(command.models, same);
  if (!command.checkers.empty()) options.checkers = parsedList<CheckerKind>(command.checkers, checker);
  if (!command.clearance.empty()) options.request.clearance = parseMetres(command.clearance, "--clearance");
  if (!command.tolerance.empty()) options.request.options.tolerance = parseTolerance(command.tolerance, "--tolerance");
  options.others = jointPositions(command.at, "--at");
  check(options);
}

Input robotOf(const Command& command) {
  Input input = openInput(command.robot, {command.package_path, {}, false, "plan_benchmark"});
  if (input.kind == Input::Kind::kRobot) return input;
  throw Error(ErrorCode::kBadOption, "'" + command.robot + "' is a mesh, and only a robot can plan; give a robot description or a package");
}

int run(Command& command) {
  interpret(command);
  const Input robot = robotOf(command);
  const Kinematics kinematics(robot.robot);
  const JointSpace space(kinematics, command.options.joints, command.options.others);
  std::vector<Scene> scenes;
  for (const std::string& file : command.scenes) scenes.push_back(readScene(file, robot.find_package, {}, {}, command.package_path));
  fs::create_directories(command.output);
  CsvFile csv(fs::path(command.output) / "queries.csv", planHeader());
  const PlanResults results = runPlanBenchmark(robot, scenes, command.options, [&](const PlanRow& row) {
    csv.add(toCsv(row));
    std::cerr << row.scene << " " << row.query << " " << name(row.checker) << " " << row.model << ": " << name(row.outcome) << "\n";
  });
  writeNamedFile(fs::path(command.output) / "plan.json",
                 planSummary(results, robot.robot.name, space.joints(), command.options).dump(2) + "\n");
  return 0;
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  using namespace collision_hulls;
  return runMeasuringProgram<Command>({"plan_benchmark", kPurpose, kFooter, {}, addOptions, run}, argc, argv);
}
