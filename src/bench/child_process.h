// Runs a program in a process of its own, measures it, and ends it when its time is up.
#pragma once

#include <string>
#include <vector>

namespace collision_hulls {

/// How a process ended and what it used.
struct ChildResult {
  enum class End { kExit, kSignal, kTimeout } end = End::kExit;
  int code = 0;            ///< exit status, or the number of the signal
  double cpu_seconds = 0;  ///< user and system time, over all threads and processes of its group
  double wall_seconds = 0;
  double peak_mb = 0;  ///< [MiB] largest resident set of any one process; never below the caller's own size at the start
  std::string output;  ///< the end of what it wrote to stdout and stderr
};

/// Runs arguments[0] (a path, or a name on PATH) with an empty stdin and waits for at most `limit` seconds of wall time; then the program
/// and every process it started are killed. Processes that a finished program leaves behind are killed, too. A program that does not exist
/// exits with status 127. Threads may call this concurrently. Throws std::system_error if no process can be started.
ChildResult runChild(const std::vector<std::string>& arguments, double limit);

/// A command line for /bin/sh -c, with every {name} replaced by its value, as one word of the shell.
std::string filledIn(const std::string& command, const std::vector<std::pair<std::string, std::string>>& values);

}  // namespace collision_hulls
