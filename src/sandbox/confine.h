// Takes from this process what a parser of foreign bytes does not need.
#pragma once

#include <string>

#include "sandbox/wire.h"

namespace collision_hulls {

/// What is in force in this process.
struct Protection {
  bool limits = false;    ///< on address space, CPU time, new files, new processes
  bool seccomp = false;   ///< a filter of system calls: no opening, no network, no new program
  bool landlock = false;  ///< no access to any file by its path
};

/// In words: "a process of its own, confined by resource limits, seccomp, Landlock".
std::string text(const Protection& protection);

/// For good: the process may compute, use the descriptors that it has open, and end, within `limits`. It cannot open or create files or
/// sockets, start processes or programs, or trace others. It ends with its parent, the process `parent`; dumps no core; and with the status
/// kWorkerOutOfMemory if it runs out of memory. What the kernel or the build does not offer is left out, and missing in the result.
Protection confine(const WorkerLimits& limits, int parent);

}  // namespace collision_hulls
