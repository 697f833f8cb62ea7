#include "tools/progress_display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

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

TEST(ProgressDisplay, ShowsThatTimePassesWhereNothingIsReported) {
  testing::internal::CaptureStderr();
  {
    ProgressDisplay display(false, "", 0.05);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    display.step({"decompose", "arm", 1, 2, 3, 0.5, -1});
    std::this_thread::sleep_for(std::chrono::milliseconds(900));
    display.clear();
    std::this_thread::sleep_for(std::chrono::milliseconds(900));
  }
  const std::string text = testing::internal::GetCapturedStderr(), line = "50 %, 1 of 2 meshes, 3 hulls";
  ASSERT_EQ(text.find(line + "\n"), 0u) << text;
  EXPECT_EQ(text.find(line + ", 0 s at this step\n"), line.size() + 1) << text;
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 3) << text;
}

}  // namespace
}  // namespace collision_hulls
