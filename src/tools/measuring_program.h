// Shared by the measuring programs: reads the command line, runs jobs in child processes, draws charts, reports errors.
#pragma once

#include <csignal>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>

#include "base/large_pages.h"
#include "base/standard_files.h"
#include "bench/child_process.h"
#include "command_line.h"

namespace collision_hulls {

using Job = void (*)(const std::string& job_file, const std::string& result_file);

template <typename Command>
struct MeasuringProgram {
  const char *name, *purpose, *footer;
  std::map<std::string, Job> jobs;  ///< what it does when it starts itself as a child process: NAME COMMAND JOB_FILE RESULT_FILE
  void (*add_options)(CommandLine&, Command&);
  int (*run)(Command&);  ///< returns the exit status
};

/// Returns the exit status: that of run(), 0 for a job and --help, 2 for an error, which goes to stderr with the program's name.
template <typename Command>
int runMeasuringProgram(const MeasuringProgram<Command>& program, int argc, char** argv) {
  holdStandardFiles();
  takeLargePages(argv);
  CommandLine app(program.purpose, program.name);
  app.footer(program.footer);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond `ulimit -f` is then an error like a full disk
  std::signal(SIGPIPE, SIG_IGN);  // whoever reads progress may go: the tables are written all the same
  Command command;
  try {
    const auto job = argc == 4 ? program.jobs.find(argv[1]) : program.jobs.end();
    if (job != program.jobs.end()) {
      job->second(argv[2], argv[3]);
      return 0;
    }
    program.add_options(app, command);
    return app.parse(argc, argv) ? program.run(command) : 0;
  } catch (const std::exception& e) {
    std::cerr << program.name << ": " << e.what() << "\n";
  }
  return 2;
}

/// Draws charts of the tables in `folder`, with the script NAME_charts beside the executable `program`.
inline void drawCharts(const std::string& name, const std::string& program, const std::string& folder) {
  constexpr double kLimit = 600;  // [s]
  const std::string script = (std::filesystem::path(program).parent_path() / (name + "_charts")).string();
  const ChildResult drawn = runChild({script, folder}, kLimit);
  std::cerr << drawn.output;
  if (drawn.code != 0) std::cerr << name << ": no charts were drawn; `" << script << " " << folder << "` draws them from the CSV files\n";
}

}  // namespace collision_hulls
