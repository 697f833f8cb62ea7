#include "check/unit_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

ValidationPair boxPair(const Vector3d& low, const Vector3d& high) {
  ValidationPair pair;
  pair.original = surface(test_shapes::boxHull(low, high));
  pair.hulls = {test_shapes::boxHull(low, high)};
  return pair;
}

TEST(UnitFrame, HoldsAnElementOfAnySizeAboutTheOrigin) {
  for (const double size : {1e-3, 0.7, 40.0}) {
    const ValidationPair pair = boxPair(Vector3d(5, -3, 2), Vector3d(5, -3, 2) + Vector3d(size, size / 2, size / 3));
    const UnitFrame frame(pair);
    const Eigen::AlignedBox3d box = boundingBox(frame.units(pair.original));
    EXPECT_LT(box.center().norm(), 1e-9) << size;
    EXPECT_GE(box.diagonal().norm(), 0.4) << size;
    EXPECT_LE(box.diagonal().norm(), 2.1) << size;
  }
}

TEST(UnitFrame, ScaleIsAPowerOfTwoSoThatLengthsComeBackToTheBit) {
  const UnitFrame frame(boxPair({0, 0, 0}, {0.3, 0.2, 0.1}));
  int exponent = 0;
  EXPECT_EQ(std::frexp(frame.units(1), &exponent), 0.5);
  EXPECT_EQ(frame.metres(frame.units(0.123)), 0.123);
  EXPECT_LT((frame.metres(frame.units(Vector3d(0.1, 0.2, 0.3))) - Vector3d(0.1, 0.2, 0.3)).norm(), 1e-15);
}

TEST(UnitFrame, HullsStayHulls) {
  const ValidationPair pair = boxPair({1, 1, 1}, {1.5, 1.25, 1.125});
  const UnitFrame frame(pair);
  const ConvexHull hull = frame.units(pair.hulls.front());
  EXPECT_NEAR(volume(hull), volume(pair.hulls.front()) * std::pow(frame.units(1), 3), 1e-9);
  for (const Vector3d& v : hull.vertices) EXPECT_LE(planeDistance(hull, v), 1e-9);
}

/// Far from the origin, the offsets of faces are rounded with the coordinates, which the size of the element does not tell.
TEST(UnitFrame, RoundingCoversFacesFarFromTheOrigin) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  double most = 0;
  for (const double away : {0.0, 1e4, 1e8}) {
    ValidationPair pair = boxPair({0, 0, 0}, {1, 1, 1});
    for (Vector3d& v : pair.original.vertices) v = turn * v + Vector3d(away, -away, away);
    pair.hulls = {convexHull(pair.original.vertices)};
    const UnitFrame frame(pair);
    const ConvexHull hull = frame.units(pair.hulls.front());
    double beyond = 0;
    for (const Vector3d& v : hull.vertices) beyond = std::max(beyond, planeDistance(hull, v));
    EXPECT_LE(beyond, frame.rounding()) << away;
    most = std::max(most, beyond);
  }
  EXPECT_GT(most, 2e-9);
}

}  // namespace
}  // namespace collision_hulls
