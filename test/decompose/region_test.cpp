#include "collision_hulls/decompose/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision_hulls/error.h"
#include "solids.h"

namespace collision_hulls {
namespace {

constexpr double kClear = kRegionSlack;

Eigen::Isometry3d poseAt(const Eigen::Vector3d& place, double angle = 0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = place;
  return pose;
}

/// [m] How deep a point lies in a region; negative outside.
double depth(const Region& region, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const HalfSpace& side : region.sides) least = std::min(least, -side.distance(p));
  return least;
}

ConvexHull unitCube() {
  return test_shapes::boxHull({0, 0, 0}, {1, 1, 1});
}

TEST(Region, ABoxAboutItsPose) {
  const Region box = boxRegion({2, 4, 6}, poseAt({10, 0, 0}), kClear);
  EXPECT_NEAR(depth(box, {10, 0, 0}), 1, 1e-12);
  EXPECT_NEAR(depth(box, {10.5, 1.9, 0}), 0.1, 1e-12);
  EXPECT_NEAR(depth(box, {10, 0, 3.5}), -0.5, 1e-12);
  const Region turned = boxRegion({2, 4, 6}, poseAt({10, 0, 0}, 0.7), kClear);
  const Eigen::Vector3d p = poseAt({10, 0, 0}, 0.7) * Eigen::Vector3d(0.5, 1.9, 0);
  EXPECT_NEAR(depth(turned, p), 0.1, 1e-12);
}

TEST(Region, TheNormalPointsIntoAHalfSpace) {
  const Region below = halfSpaceRegion({0, 0, -2}, 0.6, kClear);  // -2 z >= 0.6
  EXPECT_NEAR(depth(below, {5, 5, -0.3}), 0, 1e-12);
  EXPECT_NEAR(depth(below, {5, 5, -1.3}), 1, 1e-12);
  EXPECT_NEAR(depth(below, {5, 5, 0}), -0.3, 1e-12);
}

TEST(Region, MovesAlong) {
  const Region box = boxRegion({2, 4, 6}, poseAt({1, 2, 3}, 0.3), kClear);
  const Eigen::Isometry3d motion = poseAt({-4, 5, 6}, 1.1);
  const Region moved = transformed(box, motion);
  test_shapes::RandomPoints random(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d p = 5 * random.inCube();
    EXPECT_NEAR(depth(moved, motion * p), depth(box, p), 1e-12);
  }
}

TEST(Region, PartOfAHull) {
  const std::optional<ConvexHull> part = partIn(unitCube(), boxRegion({1, 3, 0.5}, poseAt({1, 0.5, 0.5}), kClear));
  ASSERT_TRUE(part);
  const Eigen::AlignedBox3d box = boundingBox(*part);
  const double rim = kRegionRim / 2;
  EXPECT_LT((box.min() - Eigen::Vector3d(0.5 + rim, 0, 0.25 + rim)).norm(), 1e-9);
  EXPECT_LT((box.max() - Eigen::Vector3d(1, 1, 0.75 - rim)).norm(), 1e-9);
  EXPECT_NEAR(volume(*part), box.volume(), 1e-9);
}

TEST(Region, HoldsWhatIsDeeperThanTheRimAndNothingOutside) {
  test_shapes::RandomPoints random(2);
  int tried = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < 30; ++k) points.push_back(random.inCube());
    const ConvexHull hull = convexHull(points);
    const Region region = i % 2 ? boxRegion({0.8, 1.1, 0.5}, poseAt(0.5 * random.inCube(), random.number(0, 3)), kClear)
                                : halfSpaceRegion(random.onSphere(), random.number(-0.5, 0.5), kClear);
    const std::optional<ConvexHull> part = partIn(hull, region);
    ASSERT_TRUE(part) << i;
    for (const Eigen::Vector3d& v : part->vertices) {
      EXPECT_GT(depth(region, v), kRegionRim / 2 - 1e-9);
      EXPECT_LT(planeDistance(hull, v), 1e-9);
    }
    for (int k = 0; k < 200; ++k) {
      const Eigen::Vector3d p = test_shapes::inHull(hull, random);
      if (depth(region, p) < kRegionRim) continue;
      ++tried;
      EXPECT_LT(planeDistance(*part, p), 1e-9);
    }
  }
  EXPECT_GT(tried, 1000);
}

TEST(Region, TheRimDoesNotCount) {
  const Region below = halfSpaceRegion({0, 0, -1}, 0, kClear);
  const auto lowered = [](double by) { return test_shapes::boxHull({0, 0, -by}, {1, 1, 1}); };
  EXPECT_FALSE(partIn(lowered(0), below)) << "it stands on the plane";
  EXPECT_FALSE(partIn(lowered(0.4 * kRegionRim), below));
  EXPECT_TRUE(partIn(lowered(1.1 * kRegionRim), below));
  EXPECT_FALSE(partIn(unitCube(), boxRegion({1, 1, 1}, poseAt({3, 0, 0}), kClear)));
  Region diamond = boxRegion({0.9, 0.9, 9}, Eigen::Isometry3d(Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ())), kClear);
  diamond = transformed(diamond, poseAt({1.4, 1.4, 0}));
  EXPECT_FALSE(partIn(unitCube(), diamond)) << "none of its sides alone has the cube outside";
}

TEST(Region, EqualButForTheName) {
  Region a = boxRegion({1, 2, 3}, poseAt({0, 0, 0}), kClear), b = a;
  b.name = "mouth";
  EXPECT_TRUE(equal({a}, {b}));
  EXPECT_FALSE(equal({a}, {}));
  b.tolerance *= 2;
  EXPECT_FALSE(equal({a}, {b}));
  b = a;
  b.sides[3].offset += 1e-9;
  EXPECT_FALSE(equal({a}, {b}));
}

void expectRefused(const std::string& part, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "accepted, though " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Region, RefusesWhatIsNone) {
  const Eigen::Isometry3d here = poseAt({0, 0, 0});
  expectRefused("size [1, 0, 1]", [&] { boxRegion({1, 0, 1}, here, kClear); });
  expectRefused("all three must be positive", [&] { boxRegion({1, 1, std::nan("")}, here, kClear); });
  expectRefused("normal [0, 0, 0]", [] { halfSpaceRegion({0, 0, 0}, 1, kClear); });
  expectRefused("offset inf", [] { halfSpaceRegion({0, 0, 1}, std::numeric_limits<double>::infinity(), kClear); });
  for (const double tolerance : {0.0, -1.0, std::nan("")}) expectRefused("tolerance", [&] { halfSpaceRegion({0, 0, 1}, 0, tolerance); });
  Eigen::Isometry3d nowhere = here, stretched = here, sheared = here;
  nowhere.translation().x() = std::nan("");
  stretched.linear() *= 2;
  sheared.linear().col(1) << 0.6, 0.8, 0;  // of unit length
  for (const Eigen::Isometry3d& pose : {nowhere, stretched, sheared})
    expectRefused("must be rigid", [&] { boxRegion({1, 1, 1}, pose, kClear); });
}

TEST(Region, OneMadeByHandIsChecked) {
  Region region = halfSpaceRegion({0, 0, 1}, 0, kClear);
  region.name = "gap";
  EXPECT_NO_THROW(check(region));
  EXPECT_NO_THROW(check(boxRegion({1, 2, 3}, poseAt({1e6, 0, 0}, 0.7), kClear)));
  Region wrong = region;
  wrong.sides.clear();
  expectRefused("region 'gap' has no sides", [&] { check(wrong); });
  wrong = region;
  wrong.sides[0].normal *= 1.00001;
  expectRefused("region 'gap' has a side", [&] { check(wrong); });
  wrong = region;
  wrong.sides[0].offset = std::nan("");
  expectRefused("region 'gap' has a side", [&] { check(wrong); });
  wrong = region;
  wrong.tolerance = 0;
  expectRefused("tolerance", [&] { check(wrong); });
}

}  // namespace
}  // namespace collision_hulls
