// Drops with known outcomes: the body comes to rest on its collision model, not on its original.
#include "physics/drop.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

/// A plate with a diagonal of 0.3 m, enlarged by `more` on all sides.
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

TEST(Drop, ExactModelStandsOnTheTable) {
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

TEST(Drop, ProtrudingModelFloatsByItsProtrusion) {
  const DropResult result = dropped({plate(0.006)});
  EXPECT_EQ(result.outcome, "ok");
  EXPECT_NEAR(result.height, 0.006 / kBodySize, 1e-3);
}

TEST(Drop, ModelThatLeavesOutSurfaceSinks) {
  EXPECT_EQ(dropped({plate(-0.006)}).outcome, "sunk");
}

TEST(Drop, FallsWithoutAModel) {
  EXPECT_EQ(dropped({}).outcome, "fell");
}

}  // namespace
}  // namespace collision_hulls
