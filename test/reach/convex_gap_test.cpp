// Bounds on the distance of convex bodies, against closed-form answers and against FCL's pairs of all kinds.
#include "reach/convex_gap.h"

#include <gtest/gtest.h>

#include "bench/stability/fcl_pairs.h"
#include "geometry/random_stream.h"

namespace collision_hulls {
namespace {

PointMatrix points(const std::vector<Eigen::Vector3d>& vertices, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity()) {
  PointMatrix result(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = pose * vertices[i];
  return result;
}

void expectGap(double distance, const PointMatrix& a, const PointMatrix& b) {
  for (const Gap& gap : {convexGap(a, b), convexGap(b, a)}) {
    EXPECT_NEAR(gap.at_least, distance, 2e-6 * distance);
    EXPECT_NEAR(gap.at_most, distance, 2e-6 * distance);
  }
}

TEST(ConvexGap, Points) {
  expectGap(0, points({{1, 2, 3}}), points({{1, 2, 3}}));
  expectGap(5, points({{0, 0, 0}}), points({{3, 4, 0}}));
}

TEST(ConvexGap, LinesAndTriangles) {
  expectGap(2, points({{-1, 0, 0}, {1, 0, 0}}), points({{0, -1, 2}, {0, 1, 2}}));
  expectGap(0, points({{-1, 0, 0}, {1, 0, 0}}), points({{0, -1, 0}, {0, 1, 0}}));
  const PointMatrix triangle = points({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  expectGap(0.5, triangle, points({{1, 1, 0.5}}));
  expectGap(std::sqrt(2), triangle, points({{3, 3, 0}, {5, 5, 0}}));
  expectGap(0, triangle, points({{1, 1, -1}, {1, 1, 1}}));
}

TEST(ConvexGap, FlatBodiesBesideEachOtherDoNotTouch) {
  Random random(1, 0, 0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Isometry3d pose = Eigen::Translation3d(random.direction()) * random.rotation();
    expectGap(0.5, points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, pose), points({{1.5, 0.2, 0}, {2, 0.1, 0}, {2, 0.3, 0}}, pose));
  }
}

TEST(ConvexGap, StopsOnceTheBoundIsEnough) {
  Random random(2, 0, 0);
  for (int i = 0; i < 100; ++i) {
    const BodyPair pair = bodyPair(PairKind::kFar, 3, static_cast<std::uint64_t>(i));
    const Gap gap = convexGap(points(pair.first.vertices), points(pair.second.vertices, pair.pose), 0.1);
    EXPECT_GE(gap.at_least, 0.1);
    EXPECT_LE(gap.at_least, signedDistance(pair) + 1e-9);
  }
}

TEST(ConvexGap, BoundsHoldAndAreTight) {
  for (const PairKind kind : allPairKinds()) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const BodyPair pair = bodyPair(kind, 5, i);
      const double distance = std::max(0.0, signedDistance(pair)), rounding = 1e-9 * pair.size;
      const Gap gap = convexGap(points(pair.first.vertices), points(pair.second.vertices, pair.pose));
      EXPECT_LE(gap.at_least, distance + rounding) << name(kind) << " " << i;
      EXPECT_GE(gap.at_most, distance - rounding) << name(kind) << " " << i;
      EXPECT_LE(gap.at_most - gap.at_least, 2e-6 * distance + 100 * rounding) << name(kind) << " " << i;
    }
  }
}

}  // namespace
}  // namespace collision_hulls
