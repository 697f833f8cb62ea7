#include "decompose/least/apart.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

TriangleMesh twoBoxes(double gap, const Eigen::Vector3d& place = Eigen::Vector3d::Zero()) {
  return moved(merged({box(1, 1, 1), moved(box(1, 1, 1), {1 + gap, 0, 0})}), place);
}

TEST(Apart, PointsOfABoxNeverAre) {
  const Solid solid = solidOf(box(1, 2, 3));
  const Apart apart(solid, 0.01, 3);
  RandomPoints random(1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d a = random.on(box(1, 2, 3)), b = random.on(box(1, 2, 3)), c = random.on(box(1, 2, 3));
    EXPECT_FALSE(apart(a, b));
    EXPECT_FALSE(apart(a, b, c));
  }
}

TEST(Apart, AcrossAGapOfMoreThanTwiceTheTolerance) {
  const Solid solid = solidOf(twoBoxes(0.5));
  const Eigen::Vector3d left(0.2, 0.5, 0.5), right(1.9, 0.5, 0.5);
  for (const double tolerance : {0.1, 0.2, 0.249, 0.251, 0.3})
    EXPECT_EQ(Apart(solid, tolerance, 3)(left, right), tolerance < 0.25) << tolerance;
}

/// Where the distance is the tolerance, rounding must not decide.
TEST(Apart, NotAcrossAGapOfJustTwiceTheTolerance) {
  RandomPoints random(2);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d place = random.inCube(10);
    const Solid solid = solidOf(twoBoxes(0.5, place));
    const Apart apart(solid, 0.25, 20);
    EXPECT_FALSE(apart(place + Eigen::Vector3d(1, 0.5, 0.5), place + Eigen::Vector3d(1.5, 0.5, 0.5)));
  }
}

TEST(Apart, OnlyBeyondWhatCoordinatesOfThatSizeMayBeRoundedBy) {
  const Solid solid = solidOf(twoBoxes(0.5));
  const Eigen::Vector3d left(0.2, 0.5, 0.5), right(2.3, 0.5, 0.5);
  EXPECT_TRUE(Apart(solid, 0.2499, 3)(left, right));
  EXPECT_FALSE(Apart(solid, 0.2499, 1e9)(left, right));  // by 1e-3
}

TEST(Apart, SeesTheMiddleOfANarrowGroove) {  // 0.1 wide, in a segment of length 3
  const Solid solid = solidOf(merged({box(2, 1, 1), moved(box(0.9, 1, 1), {2.1, 0, 0})}));
  EXPECT_TRUE(Apart(solid, 0.0495, 3)({0, 0.5, 0.5}, {3, 0.5, 0.5}));
  EXPECT_FALSE(Apart(solid, 0.0505, 3)({0, 0.5, 0.5}, {3, 0.5, 0.5}));
}

TEST(Apart, ThreeWhoseTriangleLeavesTheSolidThoughNoSegmentDoes) {  // a triangular frame of bars
  const Eigen::Vector3d a(0, 0, 0), b(4, 0, 0), c(2, 3.4, 0);
  std::vector<TriangleMesh> bars;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const Eigen::Vector3d along = (to - from).normalized(), aside = 0.1 * along.unitOrthogonal(),
                          up = 0.1 * along.cross(aside.normalized());
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector3d& end : {from, to})
      for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) corners.push_back(end + x * aside + y * up);
    bars.push_back(surface(convexHull(corners)));
  }
  const Solid solid = solidOf(merged(bars));
  const Apart apart(solid, 0.5, 4);
  EXPECT_FALSE(apart(a, b) || apart(b, c) || apart(c, a));
  EXPECT_TRUE(apart(a, b, c));
}

}  // namespace
}  // namespace collision_hulls
