#include "collision_hulls/pipeline/progress_text.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(ProgressText, SaysWhatGoesOn) {
  EXPECT_EQ(progressLine({"read", "", 0, 42, 0, 0, -1}), "reading 42 meshes");
  EXPECT_EQ(progressLine({"read", "", 0, 1, 0, 0, -1}), "reading 1 mesh");
  EXPECT_EQ(progressLine({"decompose", "arm", 7, 42, 17, 0.439, 38}), "43 %, 7 of 42 meshes, 17 hulls, about 40 s left");
  EXPECT_EQ(progressLine({"decompose", "arm", 1, 1, 1, 0.5, -1}), "50 %, 1 of 1 mesh, 1 hull");
  EXPECT_EQ(progressLine({"decompose", "arm", 1, 2, 3, 0.5, -1, 12}), "50 %, 1 of 2 meshes, 3 hulls and 12 primitives");
  EXPECT_EQ(progressLine({"decompose", "arm", 1, 2, 0, 0.5, -1, 12}), "50 %, 1 of 2 meshes, 12 primitives");
  EXPECT_EQ(progressLine({"fit", "", 42, 42, 99, 0.5, 90}), "50 %, fitting to the scene, about 90 s left");
  EXPECT_EQ(progressLine({"certify", "", 42, 42, 99, 0.85, 3}), "85 %, certifying the fitted hulls, about 3 s left");
  EXPECT_EQ(stepText({"validate", "", 42, 42, 99, 0.97, 0.2}), "validating, about 1 s left");
  EXPECT_EQ(progressLine({"validate", "", 42, 42, 99, 1, 0}), "100 %, validating");
  EXPECT_EQ(progressLine({"pairs", "", 42, 42, 99, 1, -1}), "proving which links never meet");
}

TEST(ProgressText, LongTimesAreRough) {
  const auto left = [](double seconds) {
    const std::string text = stepText({"validate", "", 1, 1, 1, 0.5, seconds});
    return text.substr(text.find("about"));
  };
  EXPECT_EQ(left(9.1), "about 10 s left");
  EXPECT_EQ(left(41), "about 45 s left");
  EXPECT_EQ(left(101), "about 110 s left");
  EXPECT_EQ(left(150), "about 3 min left");
  EXPECT_EQ(left(3 * 3600 - 1), "about 3 h left");
}

TEST(ProgressText, HundredPercentIsTheEndAlone) {
  EXPECT_EQ(percent({"validate", "", 1, 1, 1, 0.9999, 0}), 99);
  EXPECT_EQ(percent({"validate", "", 1, 1, 1, 1, 0}), 100);
}

TEST(Throttle, LetsTheFirstThroughAndThenFew) {
  Throttle rarely(1e9), always(0);
  EXPECT_TRUE(rarely());
  EXPECT_FALSE(rarely());
  EXPECT_TRUE(always());
  EXPECT_TRUE(always());
}

}  // namespace
}  // namespace collision_hulls
