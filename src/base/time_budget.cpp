// The threads have (end - now) each. What running tasks were promised is taken off; the rest goes to the waiting ones in proportion to
// their costs. No task gets more than the time until the end, as one thread may have to do it.
#include "base/time_budget.h"

#include <algorithm>
#include <utility>

namespace collision_hulls {
namespace {

constexpr double kWorthwhile = 1.5;  // times what a task had before: with less it would hardly find more

RunControl::Time after(const RunControl::Time& now, double seconds) {
  return now + std::chrono::duration_cast<RunControl::Time::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

TimeBudget::TimeBudget(double seconds, Clock clock)
    : clock_(std::move(clock)), end_(seconds > 0 ? after(clock_(), seconds) : RunControl::Time::max()) {}

void TimeBudget::share(const std::vector<double>& costs, std::size_t threads) {
  threads_ = static_cast<double>(threads);
  for (const double cost : costs) tasks_.push_back({cost, State::kWaiting, end_});
}

/// [s] 0 if that is past.
double TimeBudget::left(const RunControl::Time& end, const RunControl::Time& now) const {
  return std::max(0.0, std::chrono::duration<double>(end - now).count());
}

RunControl::Time TimeBudget::begin(std::size_t task) {
  if (end_ == RunControl::Time::max()) return end_;
  const std::lock_guard<std::mutex> lock(mutex_);
  Task& mine = tasks_[task];
  if (mine.state == State::kRunning) return mine.deadline;
  const RunControl::Time now = clock_();
  double free = threads_ * left(end_, now), waiting = 0;
  for (const Task& other : tasks_) {
    if (other.state == State::kRunning) free -= left(other.deadline, now);
    if (other.state == State::kWaiting) waiting += other.cost;
  }
  const double share = waiting > 0 ? mine.cost / waiting : 1;
  mine.state = State::kRunning;
  mine.granted = std::clamp(share * free, 0.0, left(end_, now));
  return mine.deadline = after(now, mine.granted);
}

void TimeBudget::finish(std::size_t task) {
  const std::lock_guard<std::mutex> lock(mutex_);
  tasks_[task].state = State::kDone;
}

std::vector<std::size_t> TimeBudget::again(const std::vector<std::size_t>& tasks) {
  std::vector<std::size_t> result;
  if (end_ == RunControl::Time::max()) return result;
  const std::lock_guard<std::mutex> lock(mutex_);
  const double rest = left(end_, clock_());
  if (rest == 0) return result;
  double granted = 0;
  for (const std::size_t task : tasks)
    if (rest >= kWorthwhile * tasks_[task].granted) result.push_back(task), granted += tasks_[task].granted;
  if (threads_ * rest < kWorthwhile * granted) return {};
  for (const std::size_t index : result) {
    Task& task = tasks_[index];
    task.cost = task.granted;
    task.granted = rest;  // one that fails before it begins has had its turn
    task.state = State::kWaiting;
  }
  return result;
}

}  // namespace collision_hulls
