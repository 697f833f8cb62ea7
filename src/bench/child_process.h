// A program run in a process of its own, measured, and ended when its time is up.
#pragma once

#include <string>
#include <vector>

namespace collision_hulls {

/// How a process ended and what it used.
struct ChildResult {
  enum class End { kExit, kSignal, kTimeout } end = End::kExit;
  int code = 0;            ///< exit status, or the number of the signal
  double cpu_seconds = 0;  ///< user and system, over all threads and processes of its group
  double wall_seconds = 0;
  double peak_mb = 0;  ///< largest resident set of one process [MiB]; the caller's own size when it started is the least it can show
  std::string output;  ///< the end of what it wrote to stdout and stderr
};

/// Runs arguments[0] (a path, or a name that PATH holds) with an empty stdin and waits, for at most `limit` seconds of wall time: then it
/// and the processes that it started are killed, as is whatever of them a finished one leaves behind. A program that is not there exits
/// with status 127. Threads may call it side by side. Throws std::system_error where no process can be started.
ChildResult runChild(const std::vector<std::string>& arguments, double limit);

/// A command line for /bin/sh -c with every {name} replaced by its value, quoted for the shell.
std::string filledIn(const std::string& command, const std::vector<std::pair<std::string, std::string>>& values);

}  // namespace collision_hulls
