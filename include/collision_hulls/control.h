// How a caller follows and stops a long computation.
#pragma once

#include <atomic>
#include <functional>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Passed down by reference through every long-running stage. Thread safe: cancel() and the stages may run on different
/// threads, and `progress` may be called from any of them, one call at a time.
struct RunControl {
  /// Called with the share of the work that is done, in [0, 1], never decreasing; empty: nobody asks.
  std::function<void(double fraction)> progress;
  /// The run that this one is a part of; its cancel() stops the part too. Null for a whole run.
  const RunControl* whole = nullptr;

  void cancel() const { cancelled_.store(true); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed) || (whole && whole->cancelled()); }
  /// Throws Error(kCancelled) once cancel() was called. Stages call it at least every 0.1 s.
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
