// Divides the time of a run between its tasks.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Each task gets the part of what is left that its expected cost is of the waiting tasks', so what one saves, the others have. Thread
/// safe.
class TimeBudget {
 public:
  using Clock = std::function<RunControl::Time()>;

  /// From now on. 0 seconds: no limit.
  explicit TimeBudget(double seconds, Clock clock = std::chrono::steady_clock::now);

  /// Among tasks of these expected costs on so many threads; before any begins.
  void share(const std::vector<double>& costs, std::size_t threads);

  /// When a task that begins now, or has begun, should be done. One that takes no time need not begin.
  RunControl::Time begin(std::size_t task);
  void finish(std::size_t task);

  /// Which of these tasks, all done, may begin once more: the rest of the time is theirs, in proportion to what they had. None if that is
  /// hardly more.
  std::vector<std::size_t> again(const std::vector<std::size_t>& tasks);

 private:
  enum class State { kWaiting, kRunning, kDone };
  struct Task {
    double cost = 0;
    State state = State::kWaiting;
    RunControl::Time deadline;
    double granted = 0;  // [s] when it began
  };
  double left(const RunControl::Time& end, const RunControl::Time& now) const;

  const Clock clock_;
  const RunControl::Time end_;
  double threads_ = 1;
  std::mutex mutex_;
  std::vector<Task> tasks_;
};

}  // namespace collision_hulls
