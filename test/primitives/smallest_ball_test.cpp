#include "primitives/smallest_ball.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_hulls/primitives/primitive.h"
#include "counted_looks.h"
#include "random_points.h"

namespace collision_hulls {
namespace {

using test_shapes::RandomPoints;

TEST(SmallestBall, OfKnownSets) {
  EXPECT_LT(smallestBall({}).squared_radius, 0);
  EXPECT_EQ(smallestBall({{1, 2, 3}}).squared_radius, 0);
  EXPECT_NEAR(smallestBall({{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}}).squared_radius, 1, 1e-12);
  EXPECT_NEAR(smallestBall({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {0, 0, 0}}).squared_radius, 3, 1e-12);
  EXPECT_NEAR(smallestBall({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).squared_radius, 0, 1e-12);
}

TEST(SmallestBall, HoldsAllAndNoNearbyCentreIsBetter) {
  RandomPoints random(1);
  for (int round = 0; round < 50; ++round) {
    const std::vector<Eigen::Vector3d> points = random.cloud(30);
    const Ball ball = smallestBall(points);
    const auto radiusAt = [&](const Eigen::Vector3d& centre) {
      double most = 0;
      for (const Eigen::Vector3d& p : points) most = std::max(most, (p - centre).norm());
      return most;
    };
    EXPECT_NEAR(radiusAt(ball.centre), std::sqrt(ball.squared_radius), 1e-12);
    for (int i = 0; i < 100; ++i) EXPECT_GE(radiusAt(ball.centre + 0.01 * random.onSphere()), std::sqrt(ball.squared_radius));
  }
}

TEST(SmallestBall, LooksAtEachPointAndWheneverItMovesThem) {
  const std::vector<Eigen::Vector3d> points = test_shapes::RandomPoints(1).cloud(3 * kItemsBetweenLooks);
  EXPECT_GT(looksOf([&](const RunControl& control) { smallestBall(points, control); }), 3u + 4u) << "four points of its border have moved";
  for (const PrimitiveKind kind : {PrimitiveKind::kSphere, PrimitiveKind::kCylinder, PrimitiveKind::kCapsule})
    EXPECT_EQ(looksAfterCancel(2, [&](const RunControl& control) { enclosingPrimitive(kind, convexHull(points), control); }), 1u);
}

}  // namespace
}  // namespace collision_hulls
