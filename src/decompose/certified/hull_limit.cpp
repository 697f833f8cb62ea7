// Numbers of hulls hardly ever grow with the tolerance, so the least tolerance that makes few enough is looked for by steps outward, as
// long as the excess asks for, and then by halving the last one, in ratios. Decompositions at large tolerances take little time, so
// stepping outward costs less than stepping down from the largest would save.
#include "decompose/certified/hull_limit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace collision_hulls {
namespace {

// Ratios of successive tolerances: along a curved surface, half of the hulls need twice the tolerance.
constexpr double kLeastStep = 1.5, kMostStep = 8;
// Ratio of the last step, halved, from which on no halving is worth its time.
constexpr double kNarrow = 1.05;

}  // namespace

BoundedHulls withinLimit(double tolerance, std::size_t count, std::size_t limit, double most, BoundedHulls best, const HullsAt& at) {
  double low = tolerance, high = std::min(best.bound, most);
  const auto isFewEnough = [&](double tried) {
    BoundedHulls next = at(tried);
    count = next.hulls.size();
    const bool is_few = count <= limit;
    if (!is_few)
      low = tried;
    else
      high = std::min(tried, next.bound);
    if (is_few && next.bound < best.bound) best = std::move(next);
    return is_few;
  };
  if (limit == 1) {  // one hull is that of everything
    isFewEnough(most);
    return best;
  }
  const auto next = [&] { return low * std::clamp(static_cast<double>(count) / static_cast<double>(limit), kLeastStep, kMostStep); };
  while (next() < high && !isFewEnough(next())) {
  }
  while (high > kNarrow * low) isFewEnough(std::sqrt(low * high));
  return best;
}

}  // namespace collision_hulls
