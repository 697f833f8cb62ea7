// Calls that cannot be interrupted, and callers that can.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// What `work(control)` returns or throws, computed in a thread of its own. A cancelled caller leaves that thread behind, and throws what
/// RunControl::check() throws: for single calls of libraries that take seconds. So `work` must own all that it uses, and use no static
/// object that is destroyed when the program ends, which may be meanwhile. The control that it gets is cancelled when it is left behind.
template <class Work>
auto orLeftBehind(Work work, const RunControl& control) {
  constexpr std::chrono::milliseconds kLook{20};
  control.check();
  struct Call {
    RunControl control;
    Work work;
  };
  const std::shared_ptr<Call> call(new Call{{}, std::move(work)});
  const auto task =
      std::make_shared<std::packaged_task<decltype(call->work(call->control))()>>([call] { return call->work(call->control); });
  auto result = task->get_future();
  try {
    std::thread([task] { (*task)(); }).detach();
  } catch (const std::system_error&) {  // no more threads: then this one
    (*task)();
  }
  try {
    while (result.wait_for(kLook) != std::future_status::ready) control.check();
  } catch (...) {
    call->control.cancel();
    throw;
  }
  return result.get();
}

}  // namespace collision_hulls
