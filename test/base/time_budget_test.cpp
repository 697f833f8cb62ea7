#include "base/time_budget.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

using Clock = std::chrono::steady_clock;

/// A clock that stands still until it is set.
struct Stopped {
  RunControl::Time now{};
  TimeBudget::Clock clock() {
    return [this] { return now; };
  }
  void pass(double seconds) { now += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)); }
  /// A task begins, and is done when these have passed.
  void spend(double seconds, std::size_t task, TimeBudget& budget) {
    budget.begin(task);
    pass(seconds);
    budget.finish(task);
  }
  double until(const RunControl::Time& deadline) const { return std::chrono::duration<double>(deadline - now).count(); }
};

TEST(TimeBudget, WithoutALimitThereIsNoDeadline) {
  TimeBudget budget(0);
  budget.share({1, 1}, 2);
  EXPECT_EQ(budget.begin(0), RunControl::Time::max());
  EXPECT_EQ(budget.begin(1), RunControl::Time::max());
}

TEST(TimeBudget, TasksShareTheTimeByTheirCosts) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  budget.share({6, 3, 1}, 1);
  EXPECT_NEAR(time.until(budget.begin(0)), 6, 1e-9);
  time.pass(6);
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(1)), 3, 1e-9);
  time.pass(3);
  budget.finish(1);
  EXPECT_NEAR(time.until(budget.begin(2)), 1, 1e-9);
}

TEST(TimeBudget, WhatPassesBeforeTheTasksAreKnownCounts) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  time.pass(4);
  budget.share({1, 1}, 1);
  EXPECT_NEAR(time.until(budget.begin(0)), 3, 1e-9);
}

TEST(TimeBudget, ThreadsAddUpAndWhatRunsIsPromised) {
  Stopped time;
  TimeBudget budget(4, time.clock());
  budget.share({1, 1, 1, 1}, 2);
  EXPECT_NEAR(time.until(budget.begin(0)), 2, 1e-9);
  EXPECT_NEAR(time.until(budget.begin(1)), 2, 1e-9);
  time.pass(2);
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(2)), 2, 1e-9);
}

TEST(TimeBudget, WhatATaskSavesTheOthersHave) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  budget.share({5, 5}, 1);
  time.spend(1, 0, budget);
  EXPECT_NEAR(time.until(budget.begin(1)), 9, 1e-9);
}

TEST(TimeBudget, TasksThatNeedMoreShareTheRestByWhatTheyHad) {
  Stopped time;
  TimeBudget budget(20, time.clock());
  budget.share({1, 2, 7}, 1);
  time.spend(2, 0, budget);
  time.spend(4, 1, budget);
  time.spend(1, 2, budget);  // of 14
  EXPECT_EQ(budget.again({0, 1}), (std::vector<std::size_t>{0, 1}));
  EXPECT_NEAR(time.until(budget.begin(0)), 13 / 3.0, 1e-9) << "of 13 s, for 2 s and 4 s";
  time.pass(4);
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(1)), 9, 1e-9);
}

TEST(TimeBudget, NobodyBeginsAgainForHardlyMore) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  budget.share({4, 6}, 1);
  time.spend(4, 0, budget);
  time.spend(0.1, 1, budget);
  EXPECT_EQ(budget.again({0}), std::vector<std::size_t>()) << "5.9 s for 4 s";
  EXPECT_EQ(budget.again({}), std::vector<std::size_t>());
  TimeBudget unlimited(0);
  unlimited.share({1}, 1);
  EXPECT_EQ(unlimited.again({0}), std::vector<std::size_t>()) << "no limit cuts anything";
  TimeBudget two(16, time.clock());
  two.share({1, 1, 2}, 1);
  time.spend(4, 0, two);
  time.spend(4, 1, two);
  time.spend(1, 2, two);
  EXPECT_EQ(two.again({0, 1}), std::vector<std::size_t>()) << "7 s for 8 s";
  EXPECT_EQ(two.again({0}), std::vector<std::size_t>{0}) << "7 s for 4 s";
  two.finish(0);
  EXPECT_EQ(two.again({0}), std::vector<std::size_t>()) << "it did not begin";
  time.pass(20);
  TimeBudget over(1e-9, time.clock());
  over.share({1}, 1);
  time.pass(1);
  time.spend(0, 0, over);
  EXPECT_EQ(over.again({0}), std::vector<std::size_t>()) << "nothing is more than nothing";
}

TEST(TimeBudget, ATaskThatNeverBeganCostsNothing) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  budget.share({5, 5}, 1);
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(1)), 10, 1e-9);
}

TEST(TimeBudget, NobodyGetsMoreThanTheTimeLeft) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  budget.share({5}, 8);
  EXPECT_NEAR(time.until(budget.begin(0)), 10, 1e-9);
}

TEST(TimeBudget, AfterTheEndDeadlinesHavePassed) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  budget.share({5, 5}, 1);
  budget.begin(0);
  time.pass(20);
  EXPECT_NEAR(time.until(budget.begin(1)), 0, 1e-9);
}

TEST(TimeBudget, BeginningAgainChangesNothing) {
  Stopped time;
  TimeBudget budget(10, time.clock());
  budget.share({5, 5}, 1);
  const RunControl::Time first = budget.begin(0);
  time.pass(1);
  EXPECT_EQ(budget.begin(0), first);
}

}  // namespace
}  // namespace collision_hulls
