#include "robot/number_text.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <random>

namespace collision_hulls {
namespace {

TEST(NumberText, IsShort) {
  EXPECT_EQ(numberText(0), "0");
  EXPECT_EQ(numberText(-0.0), "0");
  EXPECT_EQ(numberText(1), "1");
  EXPECT_EQ(numberText(-0.1), "-0.1");
  EXPECT_EQ(numberText(1.5707963267949), "1.5707963267949");
  EXPECT_EQ(numberText(1200), "1200");
}

TEST(NumberText, HasNoExponent) {
  EXPECT_EQ(numberText(1e-7), "0.0000001");
  EXPECT_EQ(numberText(-2.5e-12), "-0.0000000000025");
  EXPECT_EQ(numberText(1e15), "1000000000000000");
}

TEST(NumberText, ReadsBackExactly) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::strtod(numberText(value).c_str(), nullptr), value) << "bits " << bits;
  }
  for (const double value : {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 1.0 / 3, M_PI}) {
    EXPECT_EQ(std::strtod(numberText(value).c_str(), nullptr), value);
  }
}

struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(NumberText, DoesNotDependOnTheLocale) {
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  EXPECT_EQ(numberText(1234567.25), "1234567.25");
  std::locale::global(old);
}

Eigen::Matrix3d rotationOf(const Eigen::Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

TEST(RollPitchYaw, GivesAnglesBack) {
  const Eigen::Vector3d rpy(0.3, -0.4, 2.5);
  EXPECT_LT((rollPitchYaw(rotationOf(rpy)) - rpy).norm(), 1e-14);
  EXPECT_EQ(rollPitchYaw(Eigen::Matrix3d::Identity()), Eigen::Vector3d::Zero());
}

TEST(RollPitchYaw, GivesTheRotationBackAtAndNearGimbalLock) {
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
