// stability INPUT...: where methods of decomposition hold and where they fail, and where FCL's queries do.
#include "bench/stability.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "bench/csv_file.h"
#include "bench/fcl_stability.h"
#include "bench/job_runner.h"
#include "decompose_options.h"
#include "list_options.h"
#include "measuring_program.h"
#include "pipeline/files.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

struct Command {
  std::vector<std::string> inputs, peers;
  std::string methods, tolerance, troubles;
  bool few = false, charts = true;
  int fcl_trials = 100;
  StabilityOptions options;
};

constexpr const char* kPurpose =
    "Shows where methods of decomposition hold and where they fail, on meshes in trouble, and where FCL's queries do.";

constexpr const char* kFooter = R"(
Each mesh is perturbed (rotation, jitter, scale, ...) and broken (holes, flipped faces, slivers, NaN, ...); each method then runs on
it in a process of its own, and its hulls are scored against the mesh in trouble. Without INPUT, FCL's queries alone are looked at.
Writes stability.csv, fcl.csv, heat maps (SVG, PNG) and index.html.
Exit status: 0 done, whatever the methods did: a run that hangs, dies or fails is a row; 2 wrong use.

Examples:
  stability part.stl my_robot_description -m certified,hacd -o out
  stability meshes/ -o out --peer bullet_hacd --peer bullet_vcd)";

std::string troubleChoices() {
  std::string choices;
  for (const Trouble& trouble : usualTroubles()) {
    const std::string text = name(trouble.kind);
    if (choices.find(text) == std::string::npos) choices += (choices.empty() ? "" : ", ") + text;
  }
  return choices;
}

void addOptions(CommandLine& app, Command& command) {
  StabilityOptions& options = command.options;
  app.add_option("INPUT", command.inputs, "Mesh files, folders of them, and robots (package, .urdf or .xacro)")->type_name("");
  app.add_option("-m,--methods", command.methods, "Methods: " + methodChoices() + "; all if not given")->type_name("LIST");
  app.add_option("-t,--tolerance", command.tolerance, "A length, or a share of each mesh's diagonal")->type_name("LENGTH [2%]");
  app.add_option("-o,--output", options.folder, "Output folder; files of an earlier run there are replaced")->type_name("DIR")->required();
  app.add_option("--time-limit", options.time_limit, "For each run, in seconds")->type_name("S [60]")->check(range(0.1, 1e6));
  app.add_option("--peer", command.peers,
                 "Another program, NAME='command {in} {out} {tolerance}': OBJ in, OBJ with an object per hull out, metres. "
                 "NAME alone: the program peer_NAME of this package")
      ->type_name("NAME[=COMMAND]");
  app.add_option("--seed", options.seed, "Of the troubles, and of whatever else is random")->type_name("N [1]");
  app.add_option("--draws", options.draws, "Of each random trouble, with the seed and those after it")
      ->type_name("N [1]")
      ->check(range(1, 1000));
  app.add_option("--jobs", options.jobs, "Meshes in trouble at a time; 0: as many as cores")->type_name("N [0]")->check(range(0, 10000));
  app.add_option("--troubles", command.troubles, "Troubles: " + troubleChoices() + "; all if not given")->type_name("LIST");
  app.add_flag("--few", command.few, "A third of the troubles");
  app.add_option("--fcl-trials", command.fcl_trials, "Of FCL for each kind of query and pair; 0: leave FCL out")
      ->type_name("N [100]")
      ->check(range(0, 100000));
  app.add_flag_callback(
      "--no-charts", [&command] { command.charts = false; }, "Leave out the charts and the page");
}

TroubleKind troubleKind(const std::string& text) {
  return choice("--troubles", text, troubleNamed, troubleChoices());
}

/// Leaves those of the chosen kinds, and none at all first, which the others are compared with.
void choose(const std::vector<TroubleKind>& chosen, std::vector<Trouble>& troubles) {
  const auto left_out = [&](const Trouble& trouble) {
    return trouble.kind != TroubleKind::kNone && std::find(chosen.begin(), chosen.end(), trouble.kind) == chosen.end();
  };
  troubles.erase(std::remove_if(troubles.begin(), troubles.end(), left_out), troubles.end());
}

/// Options that are lists, or of which other code says what they may be.
void interpret(Command& command) {
  StabilityOptions& options = command.options;
  options.program = fs::read_symlink("/proc/self/exe").string();
  if (!command.methods.empty()) {
    options.methods = parsedList<Method>(command.methods,
                                         [](const std::string& text) { return choice("--methods", text, methodNamed, methodChoices()); });
  }
  if (!command.tolerance.empty()) options.tolerance = parseLength(command.tolerance);
  if (command.few) options.troubles = fewTroubles();
  if (!command.troubles.empty()) choose(parsedList<TroubleKind>(command.troubles, troubleKind), options.troubles);
  for (const std::string& text : command.peers) options.peers.push_back(peerOf(text, fs::path(options.program).parent_path()));
}

std::string summary(const StabilityRow& row) {
  std::string text = row.mesh + " " + name(row.trouble.kind) + " " + csvNumber(row.trouble.amount) + " " + row.method + ": " + row.outcome;
  if (row.hulls) text += ", " + std::to_string(*row.hulls) + " hulls, protrusion " + csvNumber(row.protrusion) + " m";
  return text + (row.message.empty() ? "" : " (" + row.message + ")");
}

void testMethods(const Command& command) {
  const std::vector<BenchmarkMesh> meshes = benchmarkMeshes(command.inputs);
  CsvFile csv(fs::path(command.options.folder) / "stability.csv", stabilityHeader());
  runStability(meshes, command.options, [&](const StabilityRow& row) {
    csv.add(toCsv(row));
    std::cerr << summary(row) << "\n";
  });
}

void testFcl(const Command& command) {
  CsvFile csv(fs::path(command.options.folder) / "fcl.csv", fclStabilityHeader());
  FclStabilityOptions options;
  options.trials = command.fcl_trials;
  options.seed = command.options.seed;
  options.program = command.options.program;
  options.folder = command.options.folder;
  runFclStability(options, [&](const FclStabilityRow& row) { csv.add(toCsv(row)); });
}

int run(Command& command) {
  interpret(command);
  fs::create_directories(command.options.folder);
  if (!command.inputs.empty()) testMethods(command);
  if (command.fcl_trials > 0) testFcl(command);
  if (command.charts) drawCharts("stability", command.options.program, command.options.folder);
  return 0;
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  using namespace collision_hulls;
  return runProgram<Command>(
      {"stability", kPurpose, kFooter, {{kJobCommand, doStabilityJob}, {kFclTrialsCommand, doFclTrials}}, addOptions, run}, argc, argv);
}
