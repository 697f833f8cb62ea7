#include "tools/progress_display.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

std::string shown(ProgressDisplay& display, double seconds_left) {
  testing::internal::CaptureStderr();
  display.step({"decompose", "arm", 1, 2, 3, 0.5, seconds_left});
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressDisplay, TellsOnceHowToWaitLess) {
  ProgressDisplay display(false, "Wait less.");
  EXPECT_EQ(shown(display, 200).find("Wait less."), std::string::npos) << "a few minutes are no reason";
  EXPECT_NE(shown(display, 400).find("Wait less.\n"), std::string::npos);
  EXPECT_EQ(shown(display, 500).find("Wait less."), std::string::npos) << "said already";
}

TEST(ProgressDisplay, SaysNothingWhereItIsToBeQuiet) {
  ProgressDisplay display(true, "Wait less.");
  EXPECT_EQ(shown(display, 400), "");
}

}  // namespace
}  // namespace collision_hulls
