#include "pipeline/progress.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

/// A run of four elements at a time of the test's own.
class ProgressTest : public ::testing::Test {
 protected:
  double now_ = 100;  // [s]
  std::vector<Step> steps_;
  RunControl control_;
  StepCallback step_ = [this](const Step& step) { steps_.push_back(step); };
  Progress progress_{control_, step_, 4, [this] { return now_; }};
};

TEST_F(ProgressTest, BeginsWithReading) {
  ASSERT_EQ(steps_.size(), 1u);
  EXPECT_EQ(steps_[0].stage, "read");
  EXPECT_EQ(steps_[0].total, 4u);
  EXPECT_EQ(steps_[0].fraction, 0);
  EXPECT_LT(steps_[0].seconds_left, 0);
}

TEST_F(ProgressTest, TasksWeighWhatTheyCost) {
  progress_.begin("decompose", 0.8, {3, 1});
  EXPECT_EQ(steps_.back().stage, "decompose");
  RunControl half;
  progress_.follow(half, 0, 0.5, 1);
  now_ += 1;
  half.report(0);
  EXPECT_NEAR(steps_.back().fraction, 0.8 * 3 / 4 * 0.5, 1e-12);
  now_ += 1;
  half.report(1);
  EXPECT_NEAR(steps_.back().fraction, 0.8 * 3 / 4, 1e-12);
  now_ += 1;
  progress_.finish(1);
  EXPECT_NEAR(steps_.back().fraction, 0.8, 1e-12);
  progress_.begin("validate", 1);
  EXPECT_NEAR(steps_.back().fraction, 0.8, 1e-12);
  progress_.end();
  EXPECT_EQ(steps_.back().fraction, 1);
}

TEST_F(ProgressTest, AStageThatEndsEarlyCountsAsDone) {
  progress_.begin("decompose", 0.5, {1, 1});
  progress_.begin("validate", 1);
  EXPECT_EQ(steps_.back().fraction, 0.5);
}

TEST_F(ProgressTest, NoTasksAreDoneAtOnce) {
  progress_.begin("decompose", 0.5, {});
  EXPECT_EQ(steps_.back().fraction, 0.5);
}

TEST_F(ProgressTest, NeverGoesBack) {
  std::vector<double> fractions;
  control_.progress = [&](double fraction) { fractions.push_back(fraction); };
  progress_.begin("decompose", 1, {1});
  RunControl part;
  progress_.follow(part, 0);
  for (const double share : {0.4, 0.2, 0.6}) part.report(share);
  EXPECT_EQ(fractions, (std::vector<double>{0, 0.4, 0.4, 0.6}));
}

TEST_F(ProgressTest, CallsWithinElementsAreFew) {
  progress_.begin("decompose", 1, {1});
  RunControl part;
  progress_.follow(part, 0);
  const std::size_t before = steps_.size();
  for (int i = 0; i < 900; ++i) {
    now_ += 0.001;
    part.report(0.0005 * i);
  }
  EXPECT_EQ(steps_.size(), before + 4);  // in 0.9 s
}

TEST_F(ProgressTest, EachFinishedElementIsACall) {
  progress_.begin("decompose", 1, {1});
  const std::size_t before = steps_.size();
  progress_.finishElement("arm", 3);
  progress_.finishElement("hand", 2, 4);
  ASSERT_EQ(steps_.size(), before + 2);
  EXPECT_EQ(steps_.back().item, "hand");
  EXPECT_EQ(steps_.back().done, 2u);
  EXPECT_EQ(steps_.back().hulls, 5u);
  EXPECT_EQ(steps_.back().primitives, 4u);
}

TEST_F(ProgressTest, PartsStopWithTheRun) {
  RunControl part;
  progress_.begin("decompose", 1, {1});
  progress_.follow(part, 0);
  EXPECT_FALSE(part.cancelled());
  control_.cancel();
  EXPECT_TRUE(part.cancelled());
}

TEST_F(ProgressTest, TimeLeftFollowsFromTheTimeTaken) {
  progress_.begin("decompose", 1, {1, 3});
  now_ += 1;
  progress_.finish(0);
  EXPECT_LT(steps_.back().seconds_left, 0) << "too early to say";
  now_ += 9;
  progress_.finishElement("arm", 1);
  RunControl part;
  progress_.follow(part, 1);
  part.report(1.0 / 3);
  now_ += 0.3;
  part.report(1.0 / 3);
  EXPECT_NEAR(steps_.back().seconds_left, 10.3, 1e-9);
  EXPECT_NEAR(steps_.back().fraction, 0.5, 1e-12);
}

TEST_F(ProgressTest, WhatTheCacheHadTookNoTime) {
  progress_.begin("decompose", 1, {8, 1, 1});
  progress_.skip(0);
  now_ += 10;
  progress_.finish(1);
  EXPECT_NEAR(steps_.back().fraction, 0.9, 1e-12);
  EXPECT_NEAR(steps_.back().seconds_left, 10, 1e-9);
}

}  // namespace
}  // namespace collision_hulls
