#include "scene/low_discrepancy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/random.h"

namespace collision_hulls {
namespace {

TEST(Richtmyer, LeavesOnlySmallGaps) {
  const std::vector<std::uint64_t> steps = richtmyerSteps(8);
  ASSERT_EQ(steps.size(), 8u);
  for (const std::uint64_t step : steps) {
    std::vector<double> points{0, 1};
    for (std::uint64_t i = 1; i <= 1000; ++i) points.push_back(unitInterval(i * step));
    std::sort(points.begin(), points.end());
    double widest = 0;
    for (std::size_t i = 1; i < points.size(); ++i) widest = std::max(widest, points[i] - points[i - 1]);
    EXPECT_LT(widest, 0.0075) << "random points leave gaps of about log(1000) / 1000";
  }
}

TEST(Richtmyer, DimensionsDiffer) {
  const std::vector<std::uint64_t> steps = richtmyerSteps(40);
  EXPECT_EQ(std::set<std::uint64_t>(steps.begin(), steps.end()).size(), 40u);
}

}  // namespace
}  // namespace collision_hulls
