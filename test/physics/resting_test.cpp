// Mass and resting poses against closed-form answers.
#include "physics/resting.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision_hulls {
namespace {

ConvexHull box(double x, double y, double z, const Eigen::Vector3d& corner = Eigen::Vector3d::Zero()) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) points.push_back(corner + Eigen::Vector3d(i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0));
  return convexHull(points);
}

TEST(MassProperties, OfABoxAwayFromTheOrigin) {
  const MassProperties mass = massProperties(box(1, 2, 3, {10, 20, 30}));
  EXPECT_TRUE(mass.center.isApprox(Eigen::Vector3d(10.5, 21, 31.5), 1e-12));
  const Eigen::Vector3d expected = Eigen::Vector3d(4 + 9, 1 + 9, 1 + 4) / 12;
  EXPECT_TRUE(mass.inertia.isApprox(Eigen::Matrix3d(expected.asDiagonal()), 1e-9)) << mass.inertia;
}

TEST(RestingPoses, OfABoxAreItsFacesMostStableFirst) {
  const ConvexHull hull = box(1, 2, 3);
  const std::vector<RestingPose> poses = restingPoses(hull, massProperties(hull).center, 10);
  ASSERT_EQ(poses.size(), 6u);
  EXPECT_NEAR(poses[0].stability, std::atan2(1, 0.5), 1e-9);  // on 2 x 3
  EXPECT_NEAR(std::abs(poses[0].rotation(2, 0)), 1, 1e-9) << "x up or down";
  EXPECT_NEAR(poses[5].stability, std::atan2(0.5, 1.5), 1e-9);  // on 1 x 2
  EXPECT_EQ(restingPoses(hull, massProperties(hull).center, 2).size(), 2u);
}

TEST(RestingPoses, ExcludesFacesThatTheCentreOfMassIsNotAbove) {
  // A prism that leans by more than its width: it tips over from its small faces.
  std::vector<Eigen::Vector3d> points;
  for (const double z : {0.0, 1.0})
    for (const double x : {0.0, 0.1})
      for (const double y : {0.0, 0.1}) points.emplace_back(x + 2 * z, y, z);
  const ConvexHull hull = convexHull(points);
  const std::vector<RestingPose> poses = restingPoses(hull, massProperties(hull).center, 10);
  EXPECT_FALSE(poses.empty());
  for (const RestingPose& pose : poses)
    EXPECT_LT(std::abs(pose.rotation(2, 2)), 0.999) << "stands on a face that is horizontal in the drawing";
}

}  // namespace
}  // namespace collision_hulls
