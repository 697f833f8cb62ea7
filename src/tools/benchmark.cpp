// benchmark INPUT...: build time against certified accuracy, for our methods and other programs.
#include "bench/benchmark.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "bench/cuts.h"
#include "bench/jobs.h"
#include "bench/machine.h"
#include "bench/queries/query_benchmark.h"
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
  std::string methods, tolerances, efforts;  // between commas
  bool charts = true, queries = false;
  int cuts = 0;
  BenchmarkOptions options;
};

constexpr const char* kPurpose = "Measures decomposition methods: time and memory against accuracy, which is certified for each result.";

constexpr const char* kFooter = R"(
Writes benchmark.csv (a row per mesh, method and tolerance), queries.csv (with --queries), cuts.csv (with --cuts), machine.json,
charts (SVG, PNG) and index.html.

Exit status: 0 done, even if methods failed: a run that hangs, crashes or fails is a row; 2 usage error.

Examples:
  benchmark part.stl my_robot_description -t 5%,2%,1% -m certified,hacd -o out --repeat 5
  benchmark meshes/ -o out --peer bullet_hacd --peer vhacd='my_vhacd {in} -o {out} -e {tolerance}')";

void addOptions(CommandLine& app, Command& command) {
  BenchmarkOptions& options = command.options;
  app.add_option("INPUT", command.inputs, "Mesh files, folders of them, and robots (package, .urdf or .xacro)")->type_name("")->required();
  app.add_option("-m,--methods", command.methods, "Methods, comma-separated: " + methodChoices() + "; default: all")->type_name("LIST");
  app.add_option("-t,--tolerances", command.tolerances, "Tolerances, comma-separated: lengths, or percentages of each mesh's diagonal")
      ->type_name("LIST [5%,2%,1%]");
  app.add_option("--effort", command.efforts, "Efforts of the method certified, comma-separated: " + effortChoices())
      ->type_name("LIST [quick]");
  app.add_option("--max-vertices", options.max_vertices, "Most vertices per hull of a method, at least 8; 0: no limit")
      ->type_name("N [64]");
  app.add_option("-o,--output", options.folder, "Output folder; files of an earlier run there are replaced")->type_name("DIR")->required();
  app.add_option("--repeat", options.repeat, "Runs per row; times and memory are their medians")->type_name("N [1]")->check(range(1, 1000));
  app.add_option("--time-limit", options.time_limit, "Per run, in seconds")->type_name("S [60]")->check(range(0.1, 1e6));
  app.add_option("--peer", command.peers,
                 "Also measure another program, NAME='command {in} {out} {tolerance}': reads OBJ, writes OBJ with one object per hull, in "
                 "metres. NAME alone means this package's program peer_NAME")
      ->type_name("NAME[=COMMAND]");
  app.add_option("--seed", options.seed, "Seed of everything random")->type_name("N [1]");
  app.add_flag(
      "--queries", command.queries,
      "Also measure collision and distance queries per second and their errors, for the meshes, each method's hulls and single hulls");
  app.add_option("--cuts", command.cuts,
                 "Also measure N random cuts through the hull tree of each mesh, with leaves for the first tolerance")
      ->type_name("N [0]")
      ->check(range(0, 1000000));
  app.add_flag_callback(
      "--no-charts", [&command] { command.charts = false; }, "Do not draw charts or write index.html");
}

/// Parses the options that are lists of names or lengths.
void interpret(Command& command) {
  BenchmarkOptions& options = command.options;
  options.program = fs::read_symlink("/proc/self/exe").string();
  DecomposeOptions caps;
  caps.tolerance = 1;  // any valid value; only the caps are checked here
  caps.max_vertices = options.max_vertices;
  check(caps);
  if (!command.methods.empty()) options.methods = methodsIn(command.methods);
  if (!command.tolerances.empty())
    options.tolerances =
        parsedList<Length>(command.tolerances, [](const std::string& text) { return parseTolerance(text, "--tolerances"); });
  if (!command.efforts.empty()) {
    options.efforts =
        parsedList<Effort>(command.efforts, [](const std::string& text) { return choice("--effort", text, effortNamed, effortChoices()); });
  }
  options.peers = peersOf(command.peers, options.program);
}

std::string summary(const BenchmarkRow& row) {
  std::string text = row.mesh + " " + row.method + (row.effort.empty() ? "" : " " + row.effort) + " " + row.requested + ": " + row.status;
  if (row.hulls) text += ", " + std::to_string(*row.hulls) + " hulls, protrusion " + csvNumber(row.protrusion) + " m";
  if (row.cpu_seconds) text += ", " + csvNumber(row.cpu_seconds) + " s CPU";
  return text + (row.message.empty() ? "" : " (" + row.message + ")");
}

std::string summary(const QueryRow& row) {
  std::string text = row.subject + " " + row.workload + " " + row.method + (row.effort.empty() ? "" : " " + row.effort) +
                     (row.requested.empty() ? "" : " " + row.requested) + ": " + row.status;
  if (row.collisions_per_second)
    text += ", " + csvNumber(row.collisions_per_second) + " collision and " + csvNumber(row.distances_per_second) +
            " distance queries per second";
  if (row.phantom_rate) text += ", rate of false collisions " + csvNumber(row.phantom_rate);
  return text + (row.message.empty() ? "" : " (" + row.message + ")");
}

void writeMachine(const Command& command) {
  nlohmann::json machine = describeMachine();
  machine["seed"] = command.options.seed;
  machine["repeat"] = command.options.repeat;
  machine["time_limit"] = command.options.time_limit;
  for (const Peer& peer : command.options.peers) machine["peers"][peer.name] = peer.command;
  writeText(fs::path(command.options.folder) / "machine.json", machine.dump(1) + "\n");
}

std::vector<BenchmarkRow> measureMethods(const Command& command, const std::vector<BenchmarkMesh>& meshes) {
  std::vector<BenchmarkRow> rows;
  CsvFile csv(fs::path(command.options.folder) / "benchmark.csv", benchmarkHeader());
  runBenchmark(meshes, command.options, [&](const BenchmarkRow& row) {
    rows.push_back(row);
    csv.add(toCsv(row));
    std::cerr << summary(row) << "\n";
  });
  return rows;
}

void measureQueries(const Command& command, const BenchmarkInputs& inputs, const std::vector<BenchmarkRow>& rows) {
  const BenchmarkOptions& options = command.options;
  CsvFile csv(fs::path(options.folder) / "queries.csv", queryHeader());
  QueryOptions queries;
  queries.seed = options.seed;
  queries.program = options.program;
  queries.folder = options.folder;
  runQueries(inputs, rows, queries, [&](const QueryRow& row) {
    csv.add(toCsv(row));
    std::cerr << summary(row) << "\n";
  });
}

void measureTrees(const Command& command, const std::vector<BenchmarkMesh>& meshes) {
  CsvFile csv(fs::path(command.options.folder) / "cuts.csv", cutHeader());
  runCuts(meshes, command.options, command.options.tolerances.front(), command.cuts, [&](const CutRow& row) { csv.add(toCsv(row)); });
}

int run(Command& command) {
  interpret(command);
  BenchmarkOptions& options = command.options;
  const BenchmarkInputs inputs = benchmarkInputs(command.inputs);
  writeMachine(command);
  const fs::path hulls = fs::path(options.folder) / ".hulls";
  if (command.queries) {
    if (!std::count(options.methods.begin(), options.methods.end(), Method::kSingleHull)) options.methods.push_back(Method::kSingleHull);
    options.keep_hulls = hulls.string();
  }
  for (const char* file : {"queries.csv", "cuts.csv"}) fs::remove(fs::path(options.folder) / file);
  const std::vector<BenchmarkRow> rows = measureMethods(command, inputs.meshes);
  if (command.queries) measureQueries(command, inputs, rows);
  fs::remove_all(hulls);
  if (command.cuts > 0) measureTrees(command, inputs.meshes);
  if (command.charts) drawCharts("benchmark", options.program, options.folder);
  return 0;
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  using namespace collision_hulls;
  return runMeasuringProgram<Command>({"benchmark", kPurpose, kFooter, {{kJobCommand, doJob}}, addOptions, run}, argc, argv);
}
