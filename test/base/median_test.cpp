#include "base/median.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(Median, OfOddAndEvenCounts) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({3, 1}), 2);
  EXPECT_EQ(median({9, 1, 2}), 2);
  EXPECT_EQ(median({4, 100, 1, 2}), 3);
}

}  // namespace
}  // namespace collision_hulls
