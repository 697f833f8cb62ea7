#include "decompose/lowest_point.h"

#include <gtest/gtest.h>

#include "random_points.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

TEST(LowestPointBeyond, OfOnePlane) {
  const auto p = lowestPointBeyond({{Vector3d::UnitZ(), 0.25}}, Vector3d::UnitZ(), Vector3d::Zero(), 1);
  ASSERT_TRUE(p);
  EXPECT_NEAR(p->z(), 0.25, 1e-12);
}

TEST(LowestPointBeyond, TheApexOfThreePlanes) {
  std::vector<HalfSpace> planes;
  for (const Vector3d& normal : {Vector3d(1, 0, 1), Vector3d(-1, 1, 1), Vector3d(-1, -1, 1)})
    planes.push_back({normal.normalized(), normal.dot(Vector3d(0.1, 0.2, 0.3)) / normal.norm()});
  const auto p = lowestPointBeyond(planes, Vector3d::UnitZ(), Vector3d::Zero(), 10);
  ASSERT_TRUE(p);
  EXPECT_LT((*p - Vector3d(0.1, 0.2, 0.3)).norm(), 1e-9);
}

TEST(LowestPointBeyond, NoneWherePlanesFaceAway) {
  EXPECT_FALSE(lowestPointBeyond({{Vector3d::UnitX(), 0.5}, {-Vector3d::UnitX(), 0.5}}, Vector3d::UnitZ(), Vector3d::Zero(), 1));
}

TEST(LowestPointBeyond, NoSampleBeyondThePlanesIsLower) {
  RandomPoints random(21);
  for (int i = 0; i < 200; ++i) {
    std::vector<HalfSpace> planes;
    for (int k = 0; k < 5; ++k) planes.push_back({(random.onSphere() + Vector3d(0, 0, 0.8)).normalized(), random.number(-0.5, 0.5)});
    const auto p = lowestPointBeyond(planes, Vector3d::UnitZ(), Vector3d::Zero(), 1);
    const auto beyond = [&](const Vector3d& q, double slack) {
      for (const HalfSpace& plane : planes)
        if (plane.distance(q) < -slack) return false;
      return true;
    };
    EXPECT_TRUE(!p || beyond(*p, 1e-9)) << i;
    for (int sample = 0; sample < 200; ++sample) {
      const Vector3d q = random.inCube();
      ASSERT_TRUE(!beyond(q, 0) || (p && p->z() <= q.z() + 1e-9)) << i;
    }
  }
}

}  // namespace
}  // namespace collision_hulls
