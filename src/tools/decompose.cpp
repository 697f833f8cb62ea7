// decompose INPUT: the meshes of a robot, or one mesh, to convex hulls in a package of their own.
#include <csignal>
#include <cstdio>
#include <iostream>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "decompose_options.h"
#include "progress_display.h"

namespace collision_hulls {
namespace {

enum ExitStatus { kDone = 0, kSomeFailed = 1, kWrongUse = 2, kInterrupted = 130 };

struct Command {
  std::string input, output, json;
  bool quiet = false;
  Options options;
};

constexpr const char* kFooter = R"(
Exit status: 0 all links done; 1 some link failed (the others are written, each failure is named);
2 wrong use, unreadable input or unwritable output; 130 interrupted, with the output left as it was.
A link is degraded, which is no failure, where its hulls protrude further than the tolerance.

Examples:
  decompose pr2_description -t 5mm -o pr2_collision
  decompose arm.urdf --links '.*_finger' --max-hulls 8 --json report.json
  decompose bracket.stl -t 0.5%)";

void addOptions(CLI::App& app, Command& command) {
  app.add_option("INPUT", command.input, "A ROS package, a .urdf or .xacro file, or one mesh (.stl .dae .obj .off .ply)")
      ->type_name("")
      ->required();
  app.add_option("-o,--output", command.output, "Output folder; default ./<robot>_collision. An earlier output there is replaced")
      ->type_name("DIR")
      ->group("Output");
  app.add_option("--json", command.json, "Write the report to this file as well; - is standard output, without the table")
      ->type_name("FILE")
      ->group("Output");
  app.add_flag("--quiet", command.quiet, "Print errors only")->group("Output");
  app.add_flag_callback(
      "--version",
      [] {
        std::printf("decompose of collision_hulls %s\n", version());
        throw CLI::Success();
      },
      "Print the version and exit");
  DecomposeOptionAdder(app, command.options).addAll();
}

const RunControl* interrupted_run = nullptr;

void interrupt(int) {
  interrupted_run->cancel();  // an atomic store, which a handler may do
}

/// The first signal stops the run in order, a second one as ever.
void cancelOnSignals(const RunControl& control) {
  interrupted_run = &control;
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

void printReport(const Report& report, const Command& command) {
  if (command.json == "-") {
    std::cout << toJson(report);
  } else if (!command.quiet) {
    std::cout << toTable(report);
  }
  std::cout.flush();
  for (const ElementReport& row : report.links) {
    if (row.status == Status::kFailed) std::cerr << "decompose: " << row.link << ", " << row.uri << " failed: " << row.reason << "\n";
  }
}

/// The file that --json names is written also where the output could not be.
void writeEverything(RobotResult& result, const Command& command, const std::string& output, const RunControl& control) {
  const bool to_file = !command.json.empty() && command.json != "-";
  try {
    if (!result.single_mesh || !anyFailed(result.report)) writeOutput(result, output, control);
  } catch (const Error& e) {
    if (to_file && e.code() != ErrorCode::kCancelled) writeReport(result.report, command.json);
    throw;
  }
  if (to_file) writeReport(result.report, command.json);
}

int run(const Command& command) {
  RunControl control;
  ProgressDisplay display(command.quiet);
  control.progress = [&](double fraction) { display.fraction(fraction); };
  cancelOnSignals(control);

  check(command.options);
  const Input input = openInput(command.input);
  const std::string output = command.output.empty() ? defaultOutput(input) : command.output;
  checkOutput(output);
  RobotResult result = decompose(input, command.options, output, control, [&](const Step& step) { display.step(step); });
  display.clear();
  writeEverything(result, command, output, control);

  printReport(result.report, command);
  if (!anyFailed(result.report)) return kDone;
  return result.single_mesh ? kWrongUse : kSomeFailed;
}

int main(int argc, char** argv) {
  Command command;
  CLI::App app("Decomposes the meshes of a robot into convex hulls that cover them, and writes them with a description that uses them.",
               "decompose");
  app.footer(kFooter);
  addOptions(app, command);
  try {
    app.parse(argc, argv);
    return run(command);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    std::cerr << "decompose: " << e.what() << "; see decompose --help\n";
  } catch (const Error& e) {
    std::cerr << "decompose: " << e.what() << "\n";
    if (e.code() == ErrorCode::kCancelled) return kInterrupted;
  } catch (const std::exception& e) {
    std::cerr << "decompose: unexpected: " << e.what() << "\n";
  }
  return kWrongUse;
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  return collision_hulls::main(argc, argv);
}
