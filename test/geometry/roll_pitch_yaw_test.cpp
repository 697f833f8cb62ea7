#include "geometry/roll_pitch_yaw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

TEST(RollPitchYaw, AboutFixedAxesRollFirst) {
  const double quarter = std::acos(0.0);
  EXPECT_LT((fromRollPitchYaw({quarter, 0, quarter}) * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((fromRollPitchYaw({0, quarter, 0}) * Vector3d::UnitX() + Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(RollPitchYaw, GivesAnglesBack) {
  const Vector3d rpy(0.3, -0.4, 2.5);
  EXPECT_LT((rollPitchYaw(fromRollPitchYaw(rpy).toRotationMatrix()) - rpy).norm(), 1e-14);
  EXPECT_EQ(rollPitchYaw(Eigen::Matrix3d::Identity()), Vector3d::Zero());
}

TEST(RollPitchYaw, GivesTheRotationBackAtAndNearGimbalLock) {
  const auto rotationOf = [](const Vector3d& rpy) { return fromRollPitchYaw(rpy).toRotationMatrix(); };
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  for (const double off : {0.0, 1e-16, 1e-12, 1e-9, 1e-8, 1e-6, 1e-3}) {
    for (int i = 0; i < 100; ++i) {
      const Eigen::Matrix3d rotation = rotationOf({angle(random), (i % 2 ? 1 : -1) * (M_PI / 2 - off), angle(random)});
      EXPECT_LT((rotationOf(rollPitchYaw(rotation)) - rotation).cwiseAbs().maxCoeff(), 1e-14) << "off " << off << ", sample " << i;
    }
  }
}

}  // namespace
}  // namespace collision_hulls
