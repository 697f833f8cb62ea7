#include "geometry/random_stream.h"

#include <gtest/gtest.h>

#include <set>

#include "base/random.h"

namespace collision_hulls {
namespace {

TEST(RandomStream, IsSplitMix64) {
  const std::uint64_t start = mixed(mixed(5) ^ 6) ^ 7;
  Random random(5, 6, 7);
  EXPECT_EQ(random.bits(), mixed(start));
  EXPECT_EQ(random.bits(), mixed(start + kGoldenStep));
}

TEST(RandomStream, DependsOnSeedPairAndQuery) {
  std::set<std::uint64_t> first;
  for (const std::uint64_t seed : {1, 2})
    for (const std::uint64_t pair : {1, 2})
      for (const std::uint64_t query : {1, 2}) first.insert(Random(seed, pair, query).bits());
  EXPECT_EQ(first.size(), 8u);
}

TEST(RandomStream, StaysInItsRange) {
  Random random(1, 0, 0);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_LT(random.below(3), 3u);
    const double even = random.uniform(-2, 5), small = random.logUniform(1e-9, 1e-2);
    EXPECT_TRUE(even >= -2 && even < 5) << even;
    EXPECT_TRUE(small >= 1e-9 && small <= 1e-2 * (1 + 1e-12)) << small;
  }
}

TEST(RandomStream, DirectionsAndRotationsPointEverywhere) {
  Random random(2, 0, 0);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), turned = Eigen::Vector3d::Zero();
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d direction = random.direction();
    EXPECT_NEAR(direction.norm(), 1, 1e-12);
    sum += direction;
    const Eigen::Quaterniond rotation = random.rotation();
    EXPECT_NEAR(rotation.norm(), 1, 1e-12);
    turned += rotation * Eigen::Vector3d::UnitX();
  }
  EXPECT_LT(sum.norm(), 100);
  EXPECT_LT(turned.norm(), 100);
}

}  // namespace
}  // namespace collision_hulls
