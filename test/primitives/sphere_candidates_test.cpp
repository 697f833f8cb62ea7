#include "primitives/sphere_candidates.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

TEST(SpreadOver, IsEven) {
  const std::vector<SurfacePoint> points = spreadOver(box(1, 1, 1), 6000);
  EXPECT_NEAR(static_cast<double>(points.size()), 6000, 1);
  int top = 0, corner = 0;
  for (const SurfacePoint& at : points) {
    top += at.normal.z() > 0.5;
    corner += at.normal.z() > 0.5 && at.p.x() < 0.25 && at.p.y() < 0.25;
    EXPECT_NEAR(at.normal.norm(), 1, 1e-12);
  }
  EXPECT_NEAR(top, 1000, 2);
  EXPECT_NEAR(corner, 1000.0 / 16, 5);
}

TEST(SpreadOver, APointWithoutArea) {
  EXPECT_EQ(spreadOver({{{1, 2, 3}, {1, 2, 3}, {2, 2, 3}}, {{0, 1, 2}}}, 100).size(), 1U);
}

TEST(LargestAt, OfACubeIsTheBallInIt) {
  const Solid solid = solidOf(box(1, 1, 1));
  const TolerableSpace space(solid, Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()), 0.1, {});
  double largest = 0;
  for (const Sphere& sphere : largestAt({{0.5, 0.5, 1}, Eigen::Vector3d::UnitZ()}, space)) largest = std::max(largest, sphere.radius);
  EXPECT_NEAR(largest, 0.6, 0.02);
}

TEST(LargestAt, OfASheetIsOnIt) {
  const Solid solid = solidOf(sheet());
  const TolerableSpace space(solid, boundingBox(sheet()), 0.1, {});
  for (const Sphere& sphere : largestAt({{0.5, 0.5, 0}, Eigen::Vector3d::UnitZ()}, space)) EXPECT_NEAR(sphere.radius, 0.1, 0.02);
}

TEST(SphereAt, IsRoundedAndInTheSpace) {
  RandomPoints random(1);
  const Solid solid = solidOf(torus());
  const TolerableSpace space(solid, boundingBox(torus()), 0.1, {});
  for (int i = 0; i < 200; ++i) {
    const Sphere sphere = sphereAt(1.5 * random.inCube(), space);
    EXPECT_EQ(sphere.centre, sphere.centre.cast<float>().cast<double>());
    EXPECT_EQ(sphere.radius, static_cast<double>(static_cast<float>(sphere.radius)));
    EXPECT_LE(sphere.radius, std::max(0.0, space.radius(sphere.centre)));
    if (sphere.radius > 0) {
      EXPECT_GE(enlarged(sphere, space).radius, sphere.radius);
    }
  }
}

}  // namespace
}  // namespace collision_hulls
