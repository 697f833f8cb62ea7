// Follows a run: gathers the progress of meshes that are worked on at the same time, and passes it on one call at a time.
//
// A run is a row of stages, each a given share of the whole; a stage is a set of tasks, weighted by what they are expected to cost. The
// time left follows from the share done and the time that it took, less what came from the cache and took none.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// Thread safe. Between the starts of stages and finished elements the callback is called at most every 0.2 s; the control gets every
/// fraction.
class Progress {
 public:
  using Clock = std::function<double()>;  ///< [s]

  /// Begins the stage "read", which takes no share.
  Progress(const RunControl& control, const StepCallback& step, std::size_t elements, Clock clock = steadySeconds);

  /// Ends the stage before and begins the next one, which takes the run up to the share `until` of the whole.
  void begin(const std::string& stage, double until, std::vector<double> costs = {1});

  /// Makes `part` report the shares `from` to `to` of a task, and stop when the whole run is cancelled.
  void follow(RunControl& part, std::size_t task, double from = 0, double to = 1);

  void finish(std::size_t task) { advance(task, 1); }
  void skip(std::size_t task);  ///< done at no cost: the cache had it

  /// One element of the robot is done.
  void finishElement(const std::string& item, std::size_t hulls, std::size_t primitives = 0);

  /// The run is done: the fraction is 1.
  void end();

 private:
  static double steadySeconds();

  void advance(std::size_t task, double share);
  void update();
  void call();

  const RunControl& control_;
  const StepCallback& step_;
  const Clock clock_;
  const double start_;    // [s]
  double last_call_ = 0;  // [s]
  std::mutex mutex_;
  double from_ = 0, until_ = 0;         // of the whole, what the stage begins and ends with
  std::vector<double> costs_, shares_;  // of the stage's tasks: weight, and share done
  double free_ = 0;                     // of the whole, what was done at no cost
  Step state_;
};

}  // namespace collision_hulls
