// Steps of several links are joined; those that a slider could not tell apart count as one, the coarser, at which all of them have changed.
#include "panel/tolerance_scale.h"

#include <algorithm>
#include <cmath>

namespace collision_hulls {
namespace {

double roundedToThreeDigits(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::round(value / unit) * unit;
}

/// The step nearest to a tolerance, as ratios go.
std::vector<double>::const_iterator nearest(const std::vector<double>& steps, double tolerance) {
  const auto above = std::lower_bound(steps.begin(), steps.end(), tolerance);
  if (above == steps.begin()) return above;
  if (above == steps.end()) return above - 1;
  return *above / tolerance < tolerance / *(above - 1) ? above : above - 1;
}

}  // namespace

ToleranceScale::ToleranceScale(const std::vector<std::vector<double>>& steps) {
  std::vector<double> all;
  for (const std::vector<double>& of_link : steps) all.insert(all.end(), of_link.begin(), of_link.end());
  if (all.empty()) return;
  std::sort(all.begin(), all.end());
  finest_ = all.front();
  coarsest_ = std::max(all.back(), 1.01 * finest_);
  for (const double step : all) {
    if (!steps_.empty() && positionOf(steps_.back()) == positionOf(step)) steps_.pop_back();
    steps_.push_back(step);
  }
}

double ToleranceScale::toleranceAt(int position) const {
  const double share = static_cast<double>(std::clamp(position, 0, kPositions)) / kPositions;
  const double tolerance = finest_ * std::pow(coarsest_ / finest_, share);
  return steps_.empty() ? roundedToThreeDigits(tolerance) : *nearest(steps_, tolerance);
}

int ToleranceScale::positionOf(double tolerance) const {
  const double share = std::log(std::clamp(tolerance, finest_, coarsest_) / finest_) / std::log(coarsest_ / finest_);
  return static_cast<int>(std::lround(share * kPositions));
}

double ToleranceScale::stepFrom(double tolerance, int by) const {
  if (steps_.empty()) return toleranceAt(positionOf(tolerance) + 20 * by);
  const auto index = nearest(steps_, tolerance) - steps_.begin() + by;
  return steps_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(steps_.size()) - 1))];
}

}  // namespace collision_hulls
