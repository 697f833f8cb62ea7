#include "panel/region_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_hulls/config/link_decisions.h"

namespace collision_hulls {
namespace {

using Vector = Eigen::Vector3d;

const RegionHandle kWhole, kRight{0, 1}, kLeft{0, -1}, kTop{2, 1};

RegionBox box(const Vector& center, const Vector& size, const Vector& rpy = Vector::Zero()) {
  return {center, size, rpy};
}

Eigen::AlignedBox3d around(const Vector& low, const Vector& high) {
  return {low, high};
}

/// A handle that was moved along an axis of its own.
RegionShape pulled(const RegionShape& shape, const RegionHandle& handle, const Vector& by) {
  return dragged(shape, handle, poseOf(shape, handle, {}) * Eigen::Translation3d(by));
}

const RegionBox& asBox(const RegionShape& shape) {
  return std::get<RegionBox>(shape);
}

const RegionHalfSpace& asHalfSpace(const RegionShape& shape) {
  return std::get<RegionHalfSpace>(shape);
}

TEST(RegionShape, ABoxHasAHandleOnEachFaceAndAHalfSpaceHasOne) {
  std::vector<std::string> names;
  for (const RegionHandle& handle : handlesOf(box({0, 0, 0}, {1, 1, 1}))) names.push_back(handle.name());
  EXPECT_EQ((std::vector<std::string>{"whole", "+x", "-x", "+y", "-y", "+z", "-z"}), names);
  EXPECT_EQ(1u, handlesOf(RegionHalfSpace()).size());
}

TEST(RegionShape, HandlesLieOnTheFaces) {
  const RegionBox turned = box({1, 0, 0}, {0.2, 0.4, 0.6}, {0, 0, M_PI / 2});
  EXPECT_TRUE(poseOf(turned, kRight, {}).translation().isApprox(Vector(1, 0.1, 0))) << "its x axis is the link's y axis";
  EXPECT_TRUE(poseOf(turned, kLeft, {}).translation().isApprox(Vector(1, -0.1, 0)));
  EXPECT_TRUE(poseOf(turned, kTop, {}).translation().isApprox(Vector(1, 0, 0.3)));
}

TEST(RegionShape, AFaceThatIsPulledLeavesTheOppositeOneWhereItIs) {
  for (const Vector& rpy : {Vector(0, 0, 0), Vector(0.3, -0.4, 2)}) {
    const RegionBox before = box({1, 2, 3}, {0.2, 0.4, 0.6}, rpy);
    const RegionBox after = asBox(pulled(before, kRight, {0.05, 0, 0}));
    EXPECT_NEAR(0.25, after.size.x(), 1e-6);
    EXPECT_DOUBLE_EQ(0.4, after.size.y());
    EXPECT_LT((poseOf(before, kLeft, {}).translation() - poseOf(after, kLeft, {}).translation()).norm(), 3e-6);
    EXPECT_EQ(rpy, after.rpy);
  }
}

TEST(RegionShape, AFacePushedInwardStopsAMillimetreBeforeTheOppositeOne) {
  const RegionBox after = asBox(pulled(box({0, 0, 0}, {0.2, 0.2, 0.2}), kLeft, {0.5, 0, 0}));
  EXPECT_NEAR(0.001, after.size.x(), 1e-9);
  EXPECT_NEAR(0.0995, after.center.x(), 1e-9);
}

TEST(RegionShape, AMoveThatComesTwiceCountsOnce) {
  const RegionBox before = box({0, 0, 0}, {0.2, 0.2, 0.2});
  const Eigen::Isometry3d to = poseOf(before, kTop, {}) * Eigen::Translation3d(0, 0, 0.03);
  const RegionShape once = dragged(before, kTop, to), twice = dragged(once, kTop, to);
  EXPECT_EQ(asBox(once).size, asBox(twice).size);
  EXPECT_EQ(asBox(once).center, asBox(twice).center);
}

TEST(RegionShape, ABoxMovesAndTurnsAsAWhole) {
  const RegionBox before = box({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6});
  Eigen::Isometry3d to = poseOf(before, kWhole, {});
  to.translate(Vector(0.01, 0, 0)).rotate(Eigen::AngleAxisd(0.5, Vector::UnitY()));
  const RegionBox after = asBox(dragged(before, kWhole, to));
  EXPECT_TRUE(after.center.isApprox(Vector(0.11, 0.2, 0.3)));
  EXPECT_TRUE(after.rpy.isApprox(Vector(0, 0.5, 0)));
  EXPECT_EQ(before.size, after.size);
}

TEST(RegionShape, AnyTurnComesBack) {
  for (const Vector& rpy : {Vector(0.3, -0.4, 2), Vector(-3, 1.5, -1), Vector(0, 1.5708, 0), Vector(0.4, 1.5707963267948966, 0),
                            Vector(1, -1.5707963267948966, 2)}) {
    const RegionBox turned = box({0, 0, 0}, {1, 1, 1}, rpy);
    const RegionBox back = asBox(dragged(box({0, 0, 0}, {1, 1, 1}), kWhole, poseOf(turned, kWhole, {})));
    EXPECT_TRUE(poseOf(back, kWhole, {}).isApprox(poseOf(turned, kWhole, {}), 3e-4)) << back.rpy.transpose();
  }
}

TEST(RegionShape, AMoveKeepsTheDigitsOfATurn) {
  const Vector rpy(0.123456789, 0, 0);
  EXPECT_EQ(rpy, asBox(pulled(box({0, 0, 0}, {1, 1, 1}, rpy), kWhole, {0.1, 0, 0})).rpy);
}

TEST(RegionShape, AHalfSpaceMovesAlongItsNormal) {
  const RegionHalfSpace before{{0, 0, -2}, 0.1};
  EXPECT_NEAR(-0.05, poseOf(before, kWhole, {}).translation().z(), 1e-12) << "the plane is where normal . p is the offset";
  const RegionHalfSpace after = asHalfSpace(pulled(before, kWhole, {0.02, 0, 0}));
  EXPECT_EQ(before.normal, after.normal);
  EXPECT_NEAR(-0.07, poseOf(after, kWhole, {}).translation().z(), 1e-12);
}

TEST(RegionShape, AHalfSpaceTiltsAboutTheMiddleOfTheLink) {
  const RegionHalfSpace before{{0, 0, -1}, -0.2};
  const Eigen::AlignedBox3d link = around({0.4, 0, 0}, {0.6, 0.2, 1});
  Eigen::Isometry3d pose = poseOf(before, kWhole, link);
  EXPECT_TRUE(pose.translation().isApprox(Vector(0.5, 0.1, 0.2)));
  pose.rotate(Eigen::AngleAxisd(0.3, Vector::UnitY()));
  const RegionHalfSpace after = asHalfSpace(dragged(before, kWhole, pose));
  EXPECT_NEAR(after.offset, after.normal.dot(Vector(0.5, 0.1, 0.2)), 1e-4);
  EXPECT_NEAR(std::cos(0.3), -after.normal.z(), 1e-4);
}

TEST(RegionShape, ANewBoxStandsOnTheLink) {
  const RegionBox first = firstBox(around({-0.1, -0.2, 0}, {0.1, 0.2, 0.4}));
  EXPECT_TRUE(first.size.isApprox(Vector(0.2, 0.4, 0.2)));
  EXPECT_TRUE(first.center.isApprox(Vector(0, 0, 0.5)));
  EXPECT_TRUE(firstBox({}).size.isApprox(Vector(0.1, 0.1, 0.1)));
  EXPECT_GT(firstBox(around({0, 0, 0}, {1, 1, 0})).size.z(), 0) << "of a flat link";
}

TEST(RegionShape, ANewHalfSpaceIsBelowTheLink) {
  const RegionHalfSpace first = firstHalfSpace(around({-0.1, -0.2, -0.05}, {0.1, 0.2, 0.4}));
  EXPECT_EQ(Vector(0, 0, -1), first.normal);
  EXPECT_NEAR(0.05, first.offset, 1e-12);
}

TEST(RegionShape, NewRegionsAreRegions) {
  for (const Eigen::AlignedBox3d& link : {Eigen::AlignedBox3d(), around({0, 0, 0}, {1, 1, 0}), around({-9, 0, 0}, {9, 1, 1})}) {
    RegionRule rule;
    rule.shape = firstBox(link);
    EXPECT_EQ(6u, regionOf(rule).sides.size());
    rule.shape = firstHalfSpace(link);
    EXPECT_EQ(1u, regionOf(rule).sides.size());
  }
}

}  // namespace
}  // namespace collision_hulls
