#include "base/random.h"

#include <gtest/gtest.h>

#include <array>

namespace collision_hulls {
namespace {

TEST(Mixed, IsSplitmixAsPublished) {
  EXPECT_EQ(mixed(0), 0xe220a8397b1dcdafu);
  EXPECT_EQ(mixed(0x9e3779b97f4a7c15u), 0x6e789e6aa1b965f4u);
}

TEST(UnitInterval, IsHalfOpen) {
  EXPECT_EQ(unitInterval(0), 0);
  EXPECT_LT(unitInterval(~std::uint64_t{0}), 1);
  EXPECT_EQ(unitInterval(std::uint64_t{1} << 63), 0.5);
}

TEST(Dice, DependOnTheSeedAlone) {
  Dice a(1), b(1), c(2);
  for (int i = 0; i < 10; ++i) {
    const std::uint64_t bits = a.bits();
    EXPECT_EQ(bits, b.bits());
    EXPECT_NE(bits, c.bits());
  }
}

TEST(Dice, AreUniform) {
  Dice dice(3);
  std::array<int, 6> fallen{};
  for (int i = 0; i < 6000; ++i) ++fallen.at(dice.below(6));
  for (int n : fallen) EXPECT_NEAR(n, 1000, 150);
  EXPECT_EQ(dice.below(1), 0u);
}

}  // namespace
}  // namespace collision_hulls
