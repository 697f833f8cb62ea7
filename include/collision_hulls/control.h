// How a caller follows, cancels and limits a long computation. A function that takes a RunControl
// throws kCancelled once the run is cancelled, and kOutOfTime once its deadline has passed if it
// stops there, whether or not its own comment says so.
//
// For example:
//
//     #include "collision_hulls/decompose/certified_hulls.h"
//
//     RunControl control;
//     control.progress = [](double done) { std::cerr << 100 * done << " %\r"; };
//     std::future<CertifiedHulls> work = std::async(std::launch::async, [&] {
//       return certifiedHulls(mesh, options, control);
//     });  // its end waits for the thread
//     const bool late = work.wait_for(std::chrono::minutes(1)) == std::future_status::timeout;
//     if (late) control.cancel();
//     const CertifiedHulls result = work.get();  // throws kCancelled
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Passed by reference to every long-running function. Set the fields before the run starts; after
/// that, any thread may call cancel(). Any thread of the run may call `progress`, but only one at a
/// time.
struct RunControl {
  /// Called with the share of the work done so far, in [0, 1]; never decreases. May be empty. What
  /// it throws ends the work. certifiedHulls(), certifiedSpheres(), decompose() of a mesh,
  /// hullTree(), acdHulls(), hacdPartition(), hacdSegmentation(), segmentsOf() and validate()
  /// report, the last time 1; so do the functions for whole robots, see StepCallback. fitScene()
  /// stops short of 1, as nobody knows how many samples it will take. Others, such as convexHull(),
  /// repair() and leastHulls(), do not report.
  std::function<void(double fraction)> progress;
  /// Asked by every check(); true ends the run as cancel() does. For callers that learn of a
  /// cancellation only by asking. Called from any thread, from several at once. May be empty.
  std::function<bool()> ends;
  /// The run that this one is part of: cancelling it cancels this one too. Null at the top level.
  const RunControl* whole = nullptr;
  /// When the caller wants the result. The searches of the method certified and those of
  /// protrusion() and certificate() then end with what they have, see certifiedHulls(); nothing
  /// else heeds it. What it cuts short depends on the machine.
  using Time = std::chrono::steady_clock::time_point;
  Time deadline = Time::max();
  /// Makes check() throw after the deadline, for a stage whose caller goes on without it.
  bool stops_at_deadline = false;

  /// Ends the run at its next check(). It stays cancelled: the next run needs another control.
  void cancel() const { cancelled_.store(true); }
  /// Whether check() would throw kCancelled.
  bool cancelled() const {
    return cancelled_.load(std::memory_order_relaxed) || (ends && ends()) ||
           (whole && whole->cancelled());
  }
  /// The deadline, or that of the whole if it is earlier.
  Time until() const { return whole ? std::min(deadline, whole->until()) : deadline; }
  /// Whether until() has passed.
  bool late() const {
    const Time end = until();
    return end != Time::max() && std::chrono::steady_clock::now() >= end;
  }
  /// Throws Error(kCancelled) after cancel(), and kOutOfTime if it stops at the deadline. Every
  /// loop over all of a mesh calls this at least once in 16,384 items. A single library call,
  /// such as a large allocation, cannot be interrupted; see doc/limits.md.
  void check() const {
    if (cancelled()) throw Error(ErrorCode::kCancelled, "cancelled by the caller");
    if (stops_at_deadline && late())
      throw Error(ErrorCode::kOutOfTime, "the time limit has passed; allow more time");
  }
  /// For functions that report: passes a share of the work on to `progress`.
  void report(double fraction) const {
    if (progress) progress(fraction);
  }

 private:
  mutable std::atomic<bool> cancelled_{false};
};

}  // namespace collision_hulls
