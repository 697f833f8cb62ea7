// See progress.h. The fraction is the largest one reported so far, so that it never decreases.
#include "pipeline/progress.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

namespace collision_hulls {
namespace {

// Before both have passed the time left would be a guess that jumps.
constexpr double kLeastSeconds = 2, kLeastFraction = 0.05;

constexpr double kPeriod = 0.2;  // [s] between calls

}  // namespace

double Progress::steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress::Progress(const RunControl& control, const StepCallback& step, std::size_t elements, Clock clock)
    : control_(control), step_(step), clock_(std::move(clock)), start_(clock_()) {
  state_.stage = "read";
  state_.total = elements;
  call();
}

void Progress::begin(const std::string& stage, double until, std::vector<double> costs) {
  const std::lock_guard<std::mutex> lock(mutex_);
  from_ = until_;
  until_ = until;
  costs_ = std::move(costs);
  shares_.assign(costs_.size(), 0);
  state_.stage = stage;
  state_.item.clear();
  update();
  call();
}

void Progress::follow(RunControl& part, std::size_t task, double from, double to) {
  part.whole = &control_;
  part.progress = [=](double share) { advance(task, from + (to - from) * share); };
}

void Progress::advance(std::size_t task, double share) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_[task] = std::max(shares_[task], share);
  update();
  if (clock_() - last_call_ >= kPeriod) call();
}

void Progress::skip(std::size_t task) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double before = state_.fraction;
  shares_[task] = 1;
  update();
  free_ += state_.fraction - before;
  if (clock_() - last_call_ >= kPeriod) call();
}

void Progress::finishElement(const std::string& item, std::size_t hulls, std::size_t primitives) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.item = item;
  ++state_.done;
  state_.hulls += hulls;
  state_.primitives += primitives;
  call();
}

void Progress::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.item.clear();
  shares_.assign(shares_.size(), 1);
  until_ = 1;
  update();
  call();
}

/// The fraction and the time left, from the tasks' shares.
void Progress::update() {
  const double whole = std::accumulate(costs_.begin(), costs_.end(), 0.0);
  const double done = std::inner_product(costs_.begin(), costs_.end(), shares_.begin(), 0.0);
  const double share = whole > 0 ? std::min(done / whole, 1.0) : 1;
  state_.fraction = std::max(state_.fraction, share < 1 ? from_ + (until_ - from_) * share : until_);
  const double seconds = clock_() - start_, worked = state_.fraction - free_;
  state_.seconds_left = seconds >= kLeastSeconds && worked >= kLeastFraction ? seconds * (1 - state_.fraction) / worked : -1;
  control_.report(state_.fraction);
}

void Progress::call() {
  last_call_ = clock_();
  if (step_) step_(state_);
}

}  // namespace collision_hulls
