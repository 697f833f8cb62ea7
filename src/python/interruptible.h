// Long work on behalf of Python: interpreter free, Ctrl-C heeded, progress told.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Calls `work` on a thread of its own, without the interpreter's lock, and waits for it. The calling thread, which holds the lock, takes
/// it back a few times a second: to let Python handle signals, and to call `look` with the share done, in [0, 1]; once more with 1 at the
/// end. What either of them throws, such as KeyboardInterrupt, cancels the work, and is thrown once the work has ended.
/// Otherwise throws what `work` throws.
void runInterruptibly(const std::function<void(const RunControl&)>& work, const pybind11::object& look);

}  // namespace collision_hulls
