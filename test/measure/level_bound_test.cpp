#include "measure/level_bound.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

TEST(LevelBound, WithoutTrianglesNothingIsKnown) {
  const TriangleBvh surface(test_shapes::sheet());
  LevelBound<3, 4> bound({Vector3d(0, 0, 1), Vector3d(1, 0, 1), Vector3d(0, 1, 1)}, surface);
  EXPECT_TRUE(std::isinf(bound.value()));
  bound.add(-1);
  EXPECT_TRUE(std::isinf(bound.value()));
}

TEST(LevelBound, AboveOneWall) {
  const TriangleBvh surface(TriangleMesh{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}});
  LevelBound<3, 4> bound({Vector3d(1, 1, 0.3), Vector3d(2, 1, 0.3), Vector3d(1, 2, 0.2)}, surface);
  bound.add(0);
  bound.add(0);
  EXPECT_NEAR(bound.value(), 0.3, 1e-12);
}

/// Each wall alone allows 0.8, both together 0.5: at any point, one of them is within that.
TEST(LevelBound, BetweenTwoWalls) {
  const TriangleMesh wall{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}};
  const TriangleBvh surface(test_shapes::merged({wall, test_shapes::moved(wall, {0, 0, 1})}));
  LevelBound<3, 4> bound({Vector3d(0, 0, 0.2), Vector3d(1, 0, 0.8), Vector3d(0, 1, 0.5)}, surface);
  bound.add(0);
  EXPECT_NEAR(bound.value(), 0.8, 1e-12);
  bound.add(1);
  EXPECT_GE(bound.value(), 0.5);
  EXPECT_NEAR(bound.value(), 0.5, 0.03);
}

// Random input.

TEST(LevelBound, NoPointIsFurtherThanTheBound) {
  double tightest = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const TriangleMesh soup = random.soup(4, 0.8);
    const TriangleBvh surface(soup);
    const std::array<Vector3d, 3> corners{random.inCube(), random.inCube(), random.inCube()};
    LevelBound<3, 4> bound(corners, surface);
    for (int t = 0; t < 4; ++t) bound.add(t);
    double most = 0;
    for (int i = 0; i < 300; ++i)
      most = std::max(
          most,
          surface.nearest(i < 3 ? corners[static_cast<std::size_t>(i)] : random.inTriangle(corners[0], corners[1], corners[2])).distance);
    EXPECT_LE(most, bound.value() * (1 + 1e-12));
    tightest = std::max(tightest, most / bound.value());
  }
  EXPECT_GT(tightest, 0.999);
}

}  // namespace
}  // namespace collision_hulls
