#include "decompose/certified/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace collision_hulls {
namespace {

bool sameWay(const Way& a, const Way& b) {
  const auto all = [](const Way& way) {
    return std::tuple(way.weights.volume_gain, way.weights.finished_share, way.weights.finished, way.leaf_share, way.largest_side_first);
  };
  return all(a) == all(b);
}

TEST(PlanFor, AHigherEffortTriesAllThatALowerOneDoes) {
  const SearchPlan instant = planFor(Effort::kInstant), quick = planFor(Effort::kQuick), best = planFor(Effort::kBest);
  for (const auto& [less, more] : {std::pair{instant, quick}, std::pair{quick, best}}) {
    EXPECT_LT(less.ways.size(), more.ways.size());
    for (const Way& way : less.ways)
      EXPECT_TRUE(std::any_of(more.ways.begin(), more.ways.end(), [&](const Way& other) { return sameWay(way, other); }));
    EXPECT_LT(less.evaluations, more.evaluations);
    EXPECT_LE(less.most_leaves, more.most_leaves);
  }
}

TEST(PlanFor, TheFirstWayIsAlwaysTriedAndLaterOnesWhereTheyAreCheap) {
  for (const Effort effort : {Effort::kInstant, Effort::kQuick, Effort::kBest}) {
    const SearchPlan plan = planFor(effort);
    ASSERT_FALSE(plan.ways.empty());
    EXPECT_EQ(plan.ways.front().few, Way::kAnyNumber);
    for (std::size_t i = 1; i < plan.ways.size(); ++i) EXPECT_LE(plan.ways[i].few, plan.ways[i - 1].few);
  }
}

TEST(PlanFor, LeavesKeepWithinTheTolerance) {
  for (const Effort effort : {Effort::kInstant, Effort::kQuick, Effort::kBest})
    for (const Way& way : planFor(effort).ways) {
      EXPECT_GT(way.leaf_share, 0);
      EXPECT_LT(way.leaf_share, 1);
    }
}

}  // namespace
}  // namespace collision_hulls
