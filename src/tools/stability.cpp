// stability INPUT...: finds where decomposition methods hold and where they fail, and the same for FCL's queries.
#include "bench/stability/stability.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "bench/job_runner.h"
#include "bench/stability/fcl_stability.h"
#include "decompose_options.h"
#include "list_options.h"
#include "measuring_program.h"
#include "storage/csv.h"
#include "storage/files.h"

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
    "Shows where decomposition methods hold and where they fail on troubled meshes, and where FCL's queries do.";

constexpr const char* kFooter = R"(
Each mesh is perturbed (rotation, jitter, scale, ...) and broken (holes, flipped faces, slivers, NaN, ...); each method then runs on
the troubled mesh in a process of its own, and its hulls are scored against that mesh. Without INPUT, only FCL's queries are tested.
Writes stability.csv, fcl.csv, heat maps (SVG, PNG) and index.html.

Exit status: 0 done, even if methods failed: a run that hangs, crashes or fails is a row; 2 usage error.

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
  app.add_option("-m,--methods", command.methods, "Methods, comma-separated: " + methodChoices() + "; default: all")->type_name("LIST");
  app.add_option("-t,--tolerance", command.tolerance, "A length, or a percentage of each mesh's diagonal")->type_name("LENGTH [2%]");
  app.add_option("-o,--output", options.folder, "Output folder; files of an earlier run there are replaced")->type_name("DIR")->required();
  app.add_option("--time-limit", options.time_limit, "Per run, in seconds")->type_name("S [60]")->check(range(0.1, 1e6));
  app.add_option("--peer", command.peers,
                 "Also test another program, NAME='command {in} {out} {tolerance}': reads OBJ, writes OBJ with one object per hull, in "
                 "metres. NAME alone means this package's program peer_NAME")
      ->type_name("NAME[=COMMAND]");
  app.add_option("--seed", options.seed, "Seed of the troubles and of everything else random")->type_name("N [1]");
  app.add_option("--draws", options.draws, "Draws per random trouble, with the seed and the ones after it")
      ->type_name("N [1]")
      ->check(range(1, 1000));
  app.add_option("--jobs", options.jobs, "Troubled meshes in parallel; 0: one per core")->type_name("N [0]")->check(range(0, 10000));
  app.add_option("--troubles", command.troubles, "Troubles, comma-separated: " + troubleChoices() + "; default: all")->type_name("LIST");
  app.add_flag("--few", command.few, "Only a third of the troubles");
  app.add_option("--fcl-trials", command.fcl_trials, "FCL trials per kind of query and pair; 0: do not test FCL")
      ->type_name("N [100]")
      ->check(range(0, 100000));
  app.add_flag_callback(
      "--no-charts", [&command] { command.charts = false; }, "Do not draw charts or write index.html");
}

TroubleKind troubleKind(const std::string& text) {
  return choice("--troubles", text, troubleNamed, troubleChoices());
}

/// Keeps the chosen kinds, and kNone, with which the others are compared.
void choose(const std::vector<TroubleKind>& chosen, std::vector<Trouble>& troubles) {
  const auto left_out = [&](const Trouble& trouble) {
    return trouble.kind != TroubleKind::kNone && std::find(chosen.begin(), chosen.end(), trouble.kind) == chosen.end();
  };
  troubles.erase(std::remove_if(troubles.begin(), troubles.end(), left_out), troubles.end());
}

/// Parses the options that are lists of names or lengths.
void interpret(Command& command) {
  StabilityOptions& options = command.options;
  options.program = fs::read_symlink("/proc/self/exe").string();
  if (!command.methods.empty()) options.methods = methodsIn(command.methods);
  if (!command.tolerance.empty()) options.tolerance = parseTolerance(command.tolerance, "--tolerance");
  if (command.few) options.troubles = fewTroubles();
  if (!command.troubles.empty()) choose(parsedList<TroubleKind>(command.troubles, troubleKind), options.troubles);
  options.peers = peersOf(command.peers, options.program);
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
  return runMeasuringProgram<Command>(
      {"stability", kPurpose, kFooter, {{kJobCommand, doStabilityJob}, {kFclTrialsCommand, doFclTrials}}, addOptions, run}, argc, argv);
}
