// A length beside a limit, in messages.
#include "base/millimetres.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(Millimetres, HaveFourDigits) {
  EXPECT_EQ(millimetres(0.0125), "12.5 mm");
  EXPECT_EQ(millimetres(0.0123456), "12.35 mm");
}

TEST(Millimetres, TellALengthFromTheLimitThatItExceeds) {
  EXPECT_EQ(millimetresBeyond(0.0123456, 0.01), "12.35 mm") << "four digits do";
  EXPECT_EQ(millimetresBeyond(0.0100004, 0.01), "10.0004 mm");
  EXPECT_EQ(millimetresBeyond(0.01, 0.01), "10 mm") << "equal, it ends";
}

}  // namespace
}  // namespace collision_hulls
