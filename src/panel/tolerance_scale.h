// The slider's positions as tolerances: logarithmic, with a detent at every tolerance at which the number of hulls changes.
#pragma once

#include <vector>

namespace collision_hulls {

class ToleranceScale {
 public:
  static constexpr int kPositions = 1000;
  /// [m] The ends of a scale without steps.
  static constexpr double kFinest = 1e-4, kCoarsest = 0.1;

  /// [m] `steps`: of each of the links that are chosen, ascending. Without any, every tolerance of three digits is on the scale.
  explicit ToleranceScale(const std::vector<std::vector<double>>& steps = {});

  /// [m] The step nearest to a position in [0, kPositions].
  double toleranceAt(int position) const;

  /// The position nearest to a tolerance [m].
  int positionOf(double tolerance) const;

  /// [m] The next coarser (`by` > 0) or finer step than a tolerance, `by` steps away; the last one at an end.
  double stepFrom(double tolerance, int by) const;

  const std::vector<double>& steps() const { return steps_; }

 private:
  std::vector<double> steps_;  // ascending
  double finest_ = kFinest, coarsest_ = kCoarsest;
};

}  // namespace collision_hulls
