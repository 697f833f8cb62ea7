// What the programs that measure have in common: the command line read, jobs of their own done, errors told.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>

namespace collision_hulls {

/// Runs `job` (a call by the program itself: true if it was one), or else the options and `run`. The exit status: run's, 0 for --help,
/// 2 for an error, which is written to stderr under the program's name.
inline int runProgram(CLI::App& app, int argc, char** argv, const std::function<bool()>& job, const std::function<int()>& run) {
  try {
    if (job()) return 0;
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    std::cerr << app.get_name() << ": " << e.what() << "; see " << app.get_name() << " --help\n";
  } catch (const std::exception& e) {
    std::cerr << app.get_name() << ": " << e.what() << "\n";
  }
  return 2;
}

}  // namespace collision_hulls
