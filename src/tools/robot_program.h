// What the programs that make a robot's collision model have in common: signals, progress, report, exit status.
#pragma once

#include <csignal>
#include <functional>
#include <iostream>
#include <string>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "command_line.h"
#include "decompose_options.h"
#include "pipeline/files.h"
#include "progress_display.h"
#include "scene/reading.h"

namespace collision_hulls {

enum ExitStatus { kDone = 0, kSomeFailed = 1, kWrongUse = 2, kInterrupted = 130 };

/// What such a program is asked for.
struct RobotCommand {
  std::string program, input, output, json;
  bool quiet = false;
  Options options;
};

/// Input, output, report and the options of a decomposition.
inline void addRobotOptions(CommandLine& app, const std::string& input, RobotCommand& command) {
  app.add_option("INPUT", command.input, input)->type_name("")->required();
  app.add_option("-o,--output", command.output, "Output folder; default ./<robot>_collision. An earlier output there is replaced")
      ->type_name("DIR")
      ->check(notEmpty("a folder"))
      ->group("Output");
  app.add_option("--json", command.json, "Write the report to this file as well; - is standard output, without the table")
      ->type_name("FILE")
      ->check(notEmpty("a file, or - for standard output"))
      ->group("Output");
  app.add_flag("--quiet", command.quiet, "Print errors only")->group("Output");
  DecomposeOptionAdder(app, command.options).addAll();
}

inline const RunControl* interrupted_run = nullptr;

/// The first signal stops the run in order, a second one as ever.
inline void cancelOnSignals(const RunControl& control) {
  interrupted_run = &control;
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted_run->cancel(); };  // an atomic store, which a handler may do
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

inline void printReport(const Report& report, const RobotCommand& command) {
  if (command.json == "-") {
    std::cout << toJson(report);
  } else if (!command.quiet) {
    std::cout << toTable(report);
  }
  if (!std::cout.flush()) throw Error(ErrorCode::kUnwritableOutput, "cannot write to standard output; the report is lost");
  for (const ElementReport& row : report.links) {
    if (row.status == Status::kFailed)
      std::cerr << command.program << ": " << row.link << ", " << row.uri << " failed: " << row.reason << "\n";
  }
}

inline bool isFile(const std::string& json) {
  return !json.empty() && json != "-";
}

/// An output folder holds nothing but the output.
inline void checkBeside(const std::string& file, const std::string& output) {
  const auto real = [](const std::string& path) { return std::filesystem::weakly_canonical(std::filesystem::absolute(path)); };
  const std::filesystem::path within = real(file).lexically_relative(real(output));
  if (!within.empty() && *within.begin() != "..")
    throw Error(ErrorCode::kBadOption,
                "'" + file + "' lies in the output folder, which holds nothing else; give another place, or leave it out");
  checkNamedFile(file);
}

/// The file that --json names is written also where the output could not be.
inline void writeEverything(RobotResult& result, const RobotCommand& command, const std::string& output, const RunControl& control) {
  const bool to_file = isFile(command.json);
  try {
    if (!writeOutput(result, output, control))
      std::cerr << command.program << ": no mesh could be decomposed; nothing is written to '" << output << "'\n";
  } catch (const Error& e) {
    if (to_file && e.code() != ErrorCode::kCancelled) writeReport(result.report, command.json);
    throw;
  }
  if (to_file) writeReport(result.report, command.json);
}

using RobotWork =
    std::function<RobotResult(const Input& input, const std::string& output, const RunControl& control, const StepCallback& step)>;

/// Reads the input, works, writes, and prints the report. The exit status.
inline int runRobotCommand(const RobotCommand& command, const RobotWork& work) {
  static RunControl control;  // a signal may come until the program ends
  ProgressDisplay display(command.quiet);
  cancelOnSignals(control);

  check(command.options);
  if (command.options.effort != Effort::kQuick && command.options.method != Method::kCertified)
    throw Error(ErrorCode::kBadOption, std::string("effort '") + name(command.options.effort) + "' is not for method '" +
                                           name(command.options.method) + "': only certified searches; leave one of the two out");
  display.say("reading " + command.input);
  const Input input = openInput(command.input);
  if (input.kind != Input::Kind::kRobot && !command.options.links.empty())
    throw Error(ErrorCode::kBadOption,
                "links '" + command.options.links + "': '" + input.path + "' is a mesh, which has none; leave it out");
  const std::string output = command.output.empty() ? defaultOutput(input) : command.output;
  checkOutput(output);
  if (isFile(command.json)) inContext("--json", [&] { checkBeside(command.json, output); });
  RobotResult result = work(input, output, control, [&](const Step& step) { display.step(step); });
  display.clear();
  writeEverything(result, command, output, control);

  printReport(result.report, command);
  if (!anyFailed(result.report)) return kDone;
  return result.single_mesh ? kWrongUse : kSomeFailed;
}

/// Parses and runs; errors become messages on standard error and exit statuses.
inline int runRobotProgram(CommandLine& app, int argc, char** argv, const std::function<int()>& run) {
  try {
    return app.parse(argc, argv) ? run() : kDone;
  } catch (const Error& e) {
    std::cerr << app.get_name() << ": " << e.what() << "\n";
    if (e.code() == ErrorCode::kCancelled) return kInterrupted;
  } catch (const std::exception& e) {
    std::cerr << app.get_name() << ": unexpected: " << e.what() << "\n";
  }
  return kWrongUse;
}

}  // namespace collision_hulls
