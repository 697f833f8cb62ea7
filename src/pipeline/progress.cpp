#include "pipeline/progress.h"

#include <algorithm>
#include <numeric>

namespace collision_hulls {
namespace {

constexpr double kValidationShare = 0.1;  // of a run's time, about

}  // namespace

Progress::Progress(const RunControl& control, const StepCallback& step, std::size_t tasks, std::size_t elements)
    : control_(control), step_(step), tasks_(tasks, 0.0) {
  state_.stage = "decompose";
  state_.total = elements;
}

void Progress::follow(RunControl& stage, std::size_t task, double from, double to) {
  stage.whole = &control_;
  stage.progress = [=](double fraction) { advance(task, from + (to - from) * fraction); };
}

void Progress::advance(std::size_t task, double fraction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  tasks_[task] = std::max(tasks_[task], fraction);
  report();
}

void Progress::finished(const std::string& item, std::size_t hulls) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.item = item;
  ++state_.done;
  state_.hulls += hulls;
  if (step_) step_(state_);
}

void Progress::followValidation(RunControl& stage) {
  stage.whole = &control_;
  stage.progress = [this](double fraction) {
    const std::lock_guard<std::mutex> lock(mutex_);
    validation_ = std::max(validation_, fraction);
    report();
  };
}

void Progress::validated() {
  const std::lock_guard<std::mutex> lock(mutex_);
  validation_ = 1;
  report();
  state_.stage = "validate";
  state_.item.clear();
  if (step_) step_(state_);
}

void Progress::report() {
  const double done = std::accumulate(tasks_.begin(), tasks_.end(), 0.0);
  const double share = tasks_.empty() ? 1.0 : done / static_cast<double>(tasks_.size());
  control_.report((1 - kValidationShare) * share + kValidationShare * validation_);
}

}  // namespace collision_hulls
