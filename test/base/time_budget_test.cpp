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
  double until(const RunControl::Time& deadline) const { return std::chrono::duration<double>(deadline - now).count(); }
};

TEST(TimeBudget, WithoutALimitThereIsNoDeadline) {
  TimeBudget budget(0, {1, 1}, 2);
  EXPECT_EQ(budget.begin(0), RunControl::Time::max());
  EXPECT_EQ(budget.begin(1), RunControl::Time::max());
}

TEST(TimeBudget, TasksShareTheTimeByTheirCosts) {
  Stopped time;
  TimeBudget budget(10, {6, 3, 1}, 1, time.clock());
  EXPECT_NEAR(time.until(budget.begin(0)), 6, 1e-9);
  time.pass(6);
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(1)), 3, 1e-9);
  time.pass(3);
  budget.finish(1);
  EXPECT_NEAR(time.until(budget.begin(2)), 1, 1e-9);
}

TEST(TimeBudget, ThreadsAddUpAndWhatRunsIsPromised) {
  Stopped time;
  TimeBudget budget(4, {1, 1, 1, 1}, 2, time.clock());
  EXPECT_NEAR(time.until(budget.begin(0)), 2, 1e-9);
  EXPECT_NEAR(time.until(budget.begin(1)), 2, 1e-9);
  time.pass(2);
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(2)), 2, 1e-9);
}

TEST(TimeBudget, WhatATaskSavesTheOthersHave) {
  Stopped time;
  TimeBudget budget(10, {5, 5}, 1, time.clock());
  budget.begin(0);
  time.pass(1);
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(1)), 9, 1e-9);
}

TEST(TimeBudget, ATaskThatNeverBeganCostsNothing) {
  Stopped time;
  TimeBudget budget(10, {5, 5}, 1, time.clock());
  budget.finish(0);
  EXPECT_NEAR(time.until(budget.begin(1)), 10, 1e-9);
}

TEST(TimeBudget, NobodyGetsMoreThanTheTimeLeft) {
  Stopped time;
  TimeBudget budget(10, {5}, 8, time.clock());
  EXPECT_NEAR(time.until(budget.begin(0)), 10, 1e-9);
}

TEST(TimeBudget, AfterTheEndDeadlinesHavePassed) {
  Stopped time;
  TimeBudget budget(10, {5, 5}, 1, time.clock());
  budget.begin(0);
  time.pass(20);
  EXPECT_NEAR(time.until(budget.begin(1)), 0, 1e-9);
}

TEST(TimeBudget, BeginningAgainChangesNothing) {
  Stopped time;
  TimeBudget budget(10, {5, 5}, 1, time.clock());
  const RunControl::Time first = budget.begin(0);
  time.pass(1);
  EXPECT_EQ(budget.begin(0), first);
}

}  // namespace
}  // namespace collision_hulls
