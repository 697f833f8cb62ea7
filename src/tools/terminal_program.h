// What the programs for a terminal have in common: signals, pipes, errors as messages, exit status.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <iostream>
#include <new>

#include "base/large_pages.h"
#include "base/standard_files.h"
#include "collision_hulls/control.h"
#include "collision_hulls/error.h"
#include "command_line.h"

namespace collision_hulls {

enum ExitStatus { kDone = 0, kSomeFailed = 1, kWrongUse = 2, kInterrupted = 130 };

inline const RunControl* interrupted_run = nullptr;

/// The first signal ends the run cleanly, a second one kills it.
inline void cancelOnSignals(const RunControl& control) {
  interrupted_run = &control;
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted_run->cancel(); };  // an atomic store, which a handler may do
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;  // in the background, or by nohup
    sigaction(signal, &action, nullptr);
  }
}

/// From here on the first signal ends the program: nothing is left to undo, and whoever reads the report may keep it waiting.
inline void endOnSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) std::signal(signal, SIG_DFL);
  }
}

/// Whether standard output is a pipe whose reader has gone, as in `decompose ... | head -1`.
inline bool nobodyReadsOutput() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  return poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
}

/// Parses and runs; errors become messages on standard error and exit statuses.
inline int runTerminalProgram(CommandLine& app, int argc, char** argv, const std::function<int()>& run) {
  holdStandardFiles();
  takeLargePages(argv);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond `ulimit -f` is then an error like a full disk
  std::signal(SIGPIPE, SIG_IGN);  // whoever reads progress or table may go: the output is written all the same
  try {
    return app.parse(argc, argv) ? run() : kDone;
  } catch (const Error& e) {
    const bool interrupted = e.code() == ErrorCode::kCancelled;
    if (!interrupted || takesLine(STDERR_FILENO))
      std::cerr << app.get_name() << ": " << (interrupted ? "interrupted; nothing was written" : e.what()) << "\n";
    if (interrupted) return kInterrupted;
  } catch (const std::bad_alloc&) {
    std::cerr << app.get_name() << ": out of memory; use fewer --jobs, a larger tolerance or coarser meshes\n";
  } catch (const std::exception& e) {
    std::cerr << app.get_name() << ": unexpected: " << e.what() << "\n";
  }
  return kWrongUse;
}

}  // namespace collision_hulls
