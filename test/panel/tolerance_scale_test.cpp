#include "panel/tolerance_scale.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

constexpr int kEnd = ToleranceScale::kPositions;

TEST(ToleranceScale, WithoutStepsEveryToleranceOfThreeDigitsIsOnIt) {
  const ToleranceScale scale;
  EXPECT_DOUBLE_EQ(ToleranceScale::kFinest, scale.toleranceAt(0));
  EXPECT_DOUBLE_EQ(ToleranceScale::kCoarsest, scale.toleranceAt(kEnd));
  EXPECT_NEAR(0.00316, scale.toleranceAt(kEnd / 2), 1e-12);  // the geometric mean, rounded
  EXPECT_EQ(kEnd / 2, scale.positionOf(scale.toleranceAt(kEnd / 2)));
}

TEST(ToleranceScale, EveryPositionIsTheNearestStepByRatio) {
  const ToleranceScale scale({{0.001, 0.002, 0.064}});
  EXPECT_DOUBLE_EQ(0.001, scale.toleranceAt(0));
  EXPECT_DOUBLE_EQ(0.064, scale.toleranceAt(kEnd));
  EXPECT_DOUBLE_EQ(0.002, scale.toleranceAt(kEnd / 3));       // 4 mm is nearer to 2 mm than to 64 mm by ratio, and by difference
  EXPECT_DOUBLE_EQ(0.064, scale.toleranceAt(7 * kEnd / 10));  // 18.4 mm is nearer to 2 mm by difference
}

TEST(ToleranceScale, GoingToAStepsPositionGivesThatStep) {
  const ToleranceScale scale({{0.001, 0.0031, 0.0032, 0.01, 0.3}});
  for (const double step : scale.steps()) EXPECT_DOUBLE_EQ(step, scale.toleranceAt(scale.positionOf(step)));
}

TEST(ToleranceScale, StepsOfSeveralLinksAreJoined) {
  const ToleranceScale scale({{0.001, 0.01}, {}, {0.002, 0.1}});
  EXPECT_EQ((std::vector<double>{0.001, 0.002, 0.01, 0.1}), scale.steps());
}

TEST(ToleranceScale, StepsThatASliderCannotTellApartAreTheCoarser) {
  const ToleranceScale scale({{0.001, 0.0100000, 0.0100001, 0.1}});
  EXPECT_EQ((std::vector<double>{0.001, 0.0100001, 0.1}), scale.steps());
}

TEST(ToleranceScale, ASingleStepIsTheWholeScale) {
  const ToleranceScale scale(std::vector<std::vector<double>>{{0.002}});
  for (const int position : {0, kEnd / 2, kEnd}) EXPECT_DOUBLE_EQ(0.002, scale.toleranceAt(position));
  EXPECT_DOUBLE_EQ(0.002, scale.stepFrom(0.002, 1));
}

TEST(ToleranceScale, KeysGoFromStepToStepAndStopAtTheEnds) {
  const ToleranceScale scale({{0.001, 0.002, 0.004}});
  EXPECT_DOUBLE_EQ(0.002, scale.stepFrom(0.001, 1));
  EXPECT_DOUBLE_EQ(0.002, scale.stepFrom(0.004, -1));
  EXPECT_DOUBLE_EQ(0.004, scale.stepFrom(0.002, 5));
  EXPECT_DOUBLE_EQ(0.001, scale.stepFrom(0.002, -5));
  EXPECT_DOUBLE_EQ(0.002, scale.stepFrom(0.0009, 1));  // from beyond an end
}

}  // namespace
}  // namespace collision_hulls
