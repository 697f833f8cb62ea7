#include "decompose/certified/block.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

const HalfSpace kX{Eigen::Vector3d::UnitX(), 0.5}, kY{Eigen::Vector3d::UnitY(), 0.5}, kZ{Eigen::Vector3d::UnitZ(), 0.5};

class Blocks : public ::testing::Test {
 protected:
  Block block(const Cell& cell) const { return {mesh, cell}; }
  /// The volume of the hull of whatever lies below all of the planes.
  double eighth(Block block) const {
    for (const HalfSpace& plane : {kX, kY, kZ}) block = parted(block, plane, 1e-9)[0];
    return volume(hullOf(block.surface));
  }

  const TriangleMesh mesh = box(1, 1, 1, 2);
  const Solid solid{repair(mesh)};
};

TEST_F(Blocks, ContainTheSolidIfTheirRegionMatters) {
  EXPECT_NEAR(eighth(block(Cell(boundingBox(mesh), solid))), 1.0 / 8, 1e-12);
  EXPECT_NEAR(eighth(block({})), 1.0 / 8 * 5 / 6, 1e-12) << "the middle of the box is not on its surface";
}

TEST_F(Blocks, CornersOutsideTheSolidAreLeftOut) {
  Cell cell(Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(2, 2, 2)), solid);
  EXPECT_TRUE(cell.keepBelow(kX).empty());
  EXPECT_TRUE(cell.keepBelow(kY).empty());
  const std::vector<Eigen::Vector3d> corners = cell.keepBelow(kZ);
  ASSERT_FALSE(corners.empty());
  for (const Eigen::Vector3d& p : corners) EXPECT_TRUE(p.isApprox(Eigen::Vector3d(0.5, 0.5, 0.5), 1e-12));
}

TEST_F(Blocks, APlaneBesideThemDividesNothing) {
  EXPECT_EQ(parted(block(Cell(boundingBox(mesh), solid)), {Eigen::Vector3d::UnitX(), 2}, 1e-9).size(), 1u);
  EXPECT_EQ(parted(block({}), {Eigen::Vector3d::UnitX(), -2}, 1e-9).size(), 1u);
  EXPECT_EQ(halves(block({}), 1e-9).size(), 2u);
}

TEST_F(Blocks, FallIntoComponentsOnlyBeforeTheyAreCut) {
  const TriangleMesh two = merged({mesh, moved(mesh, {3, 0, 0})});
  const Solid both(repair(two));
  const Block whole{two, Cell(boundingBox(two), both)};
  EXPECT_EQ(components(whole).size(), 2u);
  const std::vector<Block> parts = parted(whole, kZ, 1e-9);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(components(parts[0]).size(), 1u);
  EXPECT_EQ(components(parted({two, {}}, kZ, 1e-9)[0]).size(), 2u) << "of the surface alone";
}

}  // namespace
}  // namespace collision_hulls
