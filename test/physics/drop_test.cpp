// Drops whose ends are known: the body stands where its collision model, not its original, lets it.
#include "physics/drop.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

/// A plate of 0.3 m diagonal, larger by `more` on all sides.
std::vector<Eigen::Vector3d> plate(double more) {
  const Eigen::Vector3d half = Eigen::Vector3d(0.10, 0.11, 0.02) + Eigen::Vector3d::Constant(more);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) points.emplace_back((i & 1 ? 1 : -1) * half.x(), (i & 2 ? 1 : -1) * half.y(), (i & 4 ? 1 : -1) * half.z());
  return points;
}

DropResult dropped(const std::vector<std::vector<Eigen::Vector3d>>& model) {
  DropBody body;
  body.original = convexHull(plate(0));
  body.hulls = model;
  return drop(body, Way::kConvex, restingPoses(body.original, Eigen::Vector3d::Zero(), 1).at(0));
}

TEST(Drop, AnExactModelStandsOnTheTable) {
  const DropResult result = dropped({plate(0)});
  EXPECT_EQ(result.outcome, "ok");
  EXPECT_NEAR(result.height, 0, 1e-3);
  EXPECT_NEAR(result.tilt, 0, 1e-2);
  EXPECT_LT(result.drift, 1e-4);
  EXPECT_LT(result.penetration, 1e-2);
  EXPECT_NEAR(result.slide, kSlide, 0.1 * kSlide);
  EXPECT_LT(result.energy, 0.01);
  EXPECT_GT(result.contacts, 2u);
}

TEST(Drop, AProtrudingModelFloatsByAsMuch) {
  const DropResult result = dropped({plate(0.006)});
  EXPECT_EQ(result.outcome, "ok");
  EXPECT_NEAR(result.height, 0.006 / kBodySize, 1e-3);
}

TEST(Drop, AModelThatLeavesTheSurfaceOutSinks) {
  EXPECT_EQ(dropped({plate(-0.006)}).outcome, "sunk");
}

TEST(Drop, WithoutAModelItFalls) {
  EXPECT_EQ(dropped({}).outcome, "fell");
}

}  // namespace
}  // namespace collision_hulls
