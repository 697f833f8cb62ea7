// How a caller follows and cancels a long computation.
//
// For example:
//
//     RunControl control;
//     control.progress = [](double done) { std::cerr << 100 * done << " %\r"; };
//     std::thread stop([&] { std::cin.get(), control.cancel(); });
//     const ConvexHull hull = convexHull(points, control);  // throws kCancelled
#pragma once

#include <atomic>
#include <functional>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Passed down by reference through every long-running stage. Thread safe: cancel() and the stages
/// may run on different threads. Any of those threads may call `progress`, but only one at a time.
struct RunControl {
  /// Called with the share of the work done so far, in [0, 1]; never decreases. May be empty.
  std::function<void(double fraction)> progress;
  /// The run that this one is part of: cancelling it cancels this one too. Null at the top level.
  const RunControl* whole = nullptr;

  void cancel() const { cancelled_.store(true); }
  bool cancelled() const {
    return cancelled_.load(std::memory_order_relaxed) || (whole && whole->cancelled());
  }
  /// Throws Error(kCancelled) after cancel(). Stages call this at least every 0.1 s.
  void check() const {
    if (cancelled()) throw Error(ErrorCode::kCancelled, "cancelled by the caller");
  }
  void report(double fraction) const {
    if (progress) progress(fraction);
  }

 private:
  mutable std::atomic<bool> cancelled_{false};
};

}  // namespace collision_hulls
