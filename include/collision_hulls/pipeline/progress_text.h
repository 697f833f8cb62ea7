// A run's progress as people read it, on a terminal, in a log or in a view.
#pragma once

#include <chrono>
#include <string>

#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// "reading 42 meshes", then "7 of 42 meshes, 17 hulls, about 40 s left", at last "validating,
/// about 2 s left".
std::string stepText(const Step& step);

/// The same after the share done: "43 %, 7 of 42 meshes, ...". The stages "read" and "pairs" have
/// none.
std::string progressLine(const Step& step);

/// The share done, rounded down: 43 for 0.439, and 100 at the end alone.
int percent(const Step& step);

/// For lines that a log keeps: true for the first call, then once in each `period` [s].
class Throttle {
 public:
  explicit Throttle(double period = 5) : period_(period) {}
  bool operator()() {
    const auto now = std::chrono::steady_clock::now();
    if (began_ && std::chrono::duration<double>(now - last_).count() < period_) return false;
    began_ = true;
    last_ = now;
    return true;
  }

 private:
  double period_;  // [s]
  bool began_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace collision_hulls
