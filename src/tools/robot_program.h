// A robot command in a terminal: progress, report, exit status.
#pragma once

#include <iostream>
#include <optional>
#include <string>

#include "progress_display.h"
#include "robot_command.h"
#include "terminal_program.h"

namespace collision_hulls {

inline void printFailures(const Report& report, const RobotCommand& command) {
  for (const std::string& failure : failures(report)) std::cerr << command.program << ": " << failure << "\n";
}

/// The table and what to do next on standard output, failures on standard error.
inline void printReport(const RobotResult& result, const RobotCommand& command, const std::string& how_to_use) {
  if (command.json == "-") {
    std::cout << toJson(result.report);
  } else if (!command.quiet) {
    std::cout << toTable(result.report) << how_to_use;
  }
  if (!std::cout.flush() && !nobodyReadsOutput())
    throw Error(ErrorCode::kUnwritableOutput, "cannot write the report to standard output; --json FILE keeps it");
  printFailures(result.report, command);
}

/// writeOutputAndReport(), which also says what came of it.
inline bool writeEverything(RobotResult& result, const RobotCommand& command, const std::string& output, const RunControl& control) {
  try {
    const bool written = writeOutputAndReport(result, command, output, control);
    if (!written) std::cerr << command.program << ": no mesh could be decomposed; nothing was written to '" << output << "'\n";
    return written;
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kCancelled) printFailures(result.report, command);
    throw;
  }
}

/// Reads the input, works, writes, and prints the report. Returns the exit status.
inline int runRobotCommand(RobotCommand& command, const RobotWork& work) {
  static RunControl control;  // a signal may come until the program ends
  ProgressDisplay display(command.quiet, command.to_wait_less);
  cancelOnSignals(control);

  std::optional<Confinement> confinement;
  confine(command, confinement);
  auto [result, output] = make(command, work, control, [&](const Step& step) {
    if (step.stage != "read") display.step(step);  // said already
  });
  display.clear();
  const bool written = writeEverything(result, command, output, control);

  endOnSignals();
  printReport(result, command,
              written ? howToUse(result, output, command.package_path) + howToLoad(command.consumers, result, output) : "");
  if (!anyFailed(result.report)) return kDone;
  return result.single_mesh && allFailed(result.report) ? kWrongUse : kSomeFailed;
}

}  // namespace collision_hulls
