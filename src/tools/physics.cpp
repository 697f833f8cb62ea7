// physics INPUT...: tries collision models in a physics engine: meshes dropped on a table and pushed, and a gripper that closes on a box.
#include "physics/physics.h"

#include <filesystem>
#include <iostream>

#include "collision_hulls/pipeline/input.h"
#include "decompose_options.h"
#include "list_options.h"
#include "measuring_program.h"
#include "storage/csv.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

struct Command {
  std::vector<std::string> inputs, peers;
  std::string methods, tolerance, robot;
  bool charts = true;
  PhysicsOptions options;
};

constexpr const char* kPurpose = "Shows how collision models behave in a physics engine: bodies on a table, a gripper with a box.";

constexpr const char* kFooter = R"(
Each mesh, scaled to a diagonal of 0.3 m, is dropped on a table in the poses in which it can stand, and pushed; the engine is DART.
With --grip, the demo robot's gripper, loaded by DART from the rewritten description, closes on a box. Writes physics.csv, grip.csv,
charts and index.html.

Exit status: 0 done, whatever happened to the bodies; 2 usage error.

Example:
  physics urdf/demo_arm.urdf --grip urdf/demo_arm.urdf -m certified,single_hull -o out)";

void addOptions(CommandLine& app, Command& command) {
  PhysicsOptions& options = command.options;
  app.add_option("INPUT", command.inputs, "Mesh files, folders of them, and robots (package, .urdf or .xacro)")->type_name("");
  app.add_option("-m,--methods", command.methods, "Methods, comma-separated: " + methodChoices() + "; default: all")->type_name("LIST");
  app.add_option("-t,--tolerance", command.tolerance, "A length, or a percentage of each mesh's diagonal")->type_name("LENGTH [2%]");
  app.add_option("-o,--output", options.folder, "Output folder; files of an earlier run there are replaced")->type_name("DIR")->required();
  app.add_option("--grip", command.robot, "A robot with the demo robot's gripper, which closes on a box")->type_name("ROBOT");
  app.add_option("--poses", options.poses, "Poses per mesh at most, the most stable first")->type_name("N [2]")->check(range(1, 100));
  app.add_option("--time-limit", options.time_limit, "Per run, in seconds")->type_name("S [120]")->check(range(0.1, 1e6));
  app.add_option("--peer", command.peers, "Also measure another program, as for benchmark")->type_name("NAME[=COMMAND]");
  app.add_option("--seed", options.seed, "Seed of everything random in the methods")->type_name("N [1]");
  app.add_flag_callback(
      "--no-charts", [&command] { command.charts = false; }, "Do not draw charts or write index.html");
}

/// Parses the options that are lists of names or lengths.
void interpret(Command& command) {
  PhysicsOptions& options = command.options;
  options.program = fs::read_symlink("/proc/self/exe").string();
  if (!command.methods.empty()) options.methods = methodsIn(command.methods);
  if (!command.tolerance.empty()) options.tolerance = parseTolerance(command.tolerance, "--tolerance");
  options.peers = peersOf(command.peers, options.program);
  if (command.inputs.empty() && command.robot.empty()) throw Error(ErrorCode::kBadOption, "nothing to do; give INPUT or --grip");
}

void dropAll(const Command& command) {
  const std::vector<BenchmarkMesh> meshes = benchmarkMeshes(command.inputs);
  CsvFile csv(fs::path(command.options.folder) / "physics.csv", physicsHeader());
  runDrops(meshes, command.options, [&](const PhysicsRow& row) {
    csv.add(toCsv(row));
    std::cerr << row.mesh << " " << row.method << " " << row.way << " " << row.pose << ": " << row.outcome << " " << row.message << "\n";
  });
}

void gripAll(const Command& command) {
  CsvFile csv(fs::path(command.options.folder) / "grip.csv", gripHeader());
  runGrips(command.robot, command.options, [&](const GripRow& row) {
    csv.add(toCsv(row));
    std::cerr << row.robot << " " << row.method << ": " << row.outcome << " " << row.message << "\n";
  });
}

int run(Command& command) {
  interpret(command);
  if (!command.robot.empty()) openInput(command.robot);  // what cannot be read fails before the long work
  fs::create_directories(command.options.folder);
  if (!command.inputs.empty()) dropAll(command);
  if (!command.robot.empty()) gripAll(command);
  if (command.charts) drawCharts("physics", command.options.program, command.options.folder);
  return 0;
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  using namespace collision_hulls;
  return runMeasuringProgram<Command>({"physics", kPurpose, kFooter, {{kJobCommand, doPhysicsJob}}, addOptions, run}, argc, argv);
}
