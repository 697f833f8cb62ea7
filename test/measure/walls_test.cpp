#include "measure/walls.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "collision_hulls/measure/solid.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

// Whatever was asked of a point before, it has the answers that the solid gives to each question alone.
TEST(Winding, AnswersDoNotDependOnThoseBefore) {
  RandomPoints random(6);
  for (const TriangleMesh& mesh : {test_shapes::boxWithWindow(0.2), test_shapes::openBox(1, 1, 1, 0.1, 3), test_shapes::box(1, 1, 1)}) {
    const Solid solid = solidOf(mesh);
    int inside = 0;
    for (int trial = 0; trial < 1000; ++trial) {
      const Vector3d p = Vector3d(0.5, 0.5, 0.5) + random.inCube(0.7);
      const double to_surface = solid.distanceToSurface(p), size = std::pow(10.0, random.number(-3, 0));
      const std::array<Vector3d, 3> patch{p + size * Vector3d(1, 0, 0), p + size * Vector3d(-0.5, 0.8, 0),
                                          p + size * Vector3d(-0.5, -0.8, 0)};
      Winding at = solid.windingAt(p), fresh = solid.windingAt(p);
      EXPECT_EQ(at.point(), p);
      EXPECT_EQ(solid.signedDistance(at, to_surface), solid.signedDistance(p, to_surface));
      EXPECT_EQ(at.isInside(), solid.contains(p));
      EXPECT_EQ(solid.isOneSide(patch, at), solid.isOneSide(patch, fresh));
      EXPECT_EQ(at.exactWayToBorder(), solid.wayToBorder(p));
      inside += at.isInside();
    }
    EXPECT_GT(inside, 50);
  }
}

TEST(Winding, ABorderThatIsSaidToBeBeyondALengthIs) {
  RandomPoints random(7);
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  int beyond = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector3d p = Vector3d(0.5, 0.5, 0.5) + random.inCube(1);
    const double length = std::pow(10.0, random.number(-2, 0));
    if (!solid.windingAt(p).isBorderBeyond(length)) continue;
    EXPECT_GT(1.001 * solid.wayToBorder(p), length) << p.transpose();
    ++beyond;
  }
  EXPECT_GT(beyond, 300);
}

// Beneath a window of a box the number is less than 1 by what the window's lid takes up of all directions.
TEST(Winding, ThroughAWindowTheOutsideTakesItsShare) {
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  EXPECT_TRUE(solid.windingAt({0.5, 0.5, 0.5}).isInside());
  EXPECT_FALSE(solid.windingAt({0.5, 0.5, 0.999}).isInside()) << "just over one half, but not surely";
  EXPECT_GT(solid.windingAt({0.5, 0.5, 1.1}).wayToHalf(), 0);
  EXPECT_TRUE(solid.windingAt({0.5, 0.5, 3}).isHalfBeyond(0.5));
  EXPECT_FALSE(solid.windingAt({0.5, 0.5, 1.01}).isHalfBeyond(0.5));
}

}  // namespace
}  // namespace collision_hulls
