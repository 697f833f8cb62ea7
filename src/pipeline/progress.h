// Gathers the progress of elements that are worked on at the same time, and tells the caller one call at a time.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/decompose_robot.h"

namespace collision_hulls {

class Progress {
 public:
  /// `tasks` pieces of work of equal weight, which finish `elements` elements, then the validation.
  Progress(const RunControl& control, const StepCallback& step, std::size_t tasks, std::size_t elements);

  /// Follows a stage that spans the shares `from` to `to` of a task; stops when the whole run is cancelled. Thread safe.
  void follow(RunControl& stage, std::size_t task, double from, double to);

  void finished(const std::string& item, std::size_t hulls);  ///< one element; thread safe
  void taskDone(std::size_t task) { advance(task, 1); }

  void followValidation(RunControl& stage);
  void validated();

 private:
  void advance(std::size_t task, double fraction);
  void report();

  const RunControl& control_;
  const StepCallback& step_;
  std::mutex mutex_;
  std::vector<double> tasks_;  // share done of each
  double validation_ = 0;      // share done
  Step state_;
};

}  // namespace collision_hulls
