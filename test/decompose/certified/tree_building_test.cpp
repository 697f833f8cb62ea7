#include "decompose/certified/tree_building.h"

#include <gtest/gtest.h>

#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

HullTree treeOf(Subject& subject, TreeBounds bounds = TreeBounds::kProved) {
  SurfaceGroups groups(subject.leaves(), 0, subject.oracle, 0);
  double share = 0;
  return treeAbove(groups.leaves(), subject.oracle, bounds, [&](double done) {
    EXPECT_TRUE(done >= share && done <= 1);
    share = done;
  });
}

TEST(TreeBuilding, WithoutProofTheBoundsAreDiagonals) {
  Subject subject(lBracket(), 0.05);
  const HullTree tree = treeOf(subject, TreeBounds::kDiagonal);
  ASSERT_GT(tree.nodes.size(), 1u);
  for (const HullNode& node : tree.nodes) {
    EXPECT_GE(node.protrusion, subject.oracle.bound({node.hull}));
    EXPECT_GE(node.protrusion, boundingBox(node.hull).diagonal().norm());
    if (node.parent >= 0) {
      EXPECT_LE(node.protrusion, tree.nodes[static_cast<std::size_t>(node.parent)].protrusion);
    }
  }
}

TEST(TreeBuilding, EstimatesAreThoseOfTheSurfaces) {
  Subject subject(torus(1, 0.3, 16, 8), 0.15);
  const HullTree tree = treeOf(subject, TreeBounds::kEstimated);
  ASSERT_GT(tree.nodes.size(), 5u);
  for (const HullNode& node : tree.nodes) {
    double most = subject.oracle.estimate(node.hull);
    for (const int child : {node.left, node.right})
      if (child >= 0) most = std::max(most, tree.nodes[static_cast<std::size_t>(child)].protrusion);
    EXPECT_NEAR(node.protrusion, most, 0.05 * most);
  }
}

TEST(TreeBuilding, OneGroupIsLeafAndRoot) {
  Subject subject(box(1, 1, 1), 0.05);
  const HullTree tree = treeOf(subject);
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.nodes[0].parent, -1);
  EXPECT_EQ(tree.nodes[0].left, -1);
  EXPECT_EQ(tree.nodes[0].right, -1);
}

TEST(TreeBuilding, WallsMergeIntoOneRoot) {
  Subject subject(uChannel(), 0.05);
  const HullTree tree = treeOf(subject);
  const std::size_t leaves = subject.leaves().size();
  ASSERT_EQ(tree.nodes.size(), 2 * leaves - 1);
  EXPECT_EQ(tree.tolerance, 0.05);
  EXPECT_EQ(subject.oracle.tolerance(), 0.05) << "the oracle's tolerance is restored";
  for (std::size_t i = 0; i < leaves; ++i) EXPECT_LE(tree.nodes[i].protrusion, 0.05);
  EXPECT_EQ(tree.nodes.back().parent, -1);
  EXPECT_NEAR(volume(tree.nodes.back().hull), 2, 1e-9);
  EXPECT_GE(tree.nodes.back().protrusion, 0.4);
  EXPECT_LE(tree.nodes.back().protrusion, 0.4 * 1.05);
}

TEST(TreeBuilding, BoundsAreProvenAndNeverDecrease) {
  Subject subject(torus(1, 0.3, 16, 8), 0.15);
  const HullTree tree = treeOf(subject);
  EXPECT_GT(tree.nodes.size(), 5u);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const HullNode& node = tree.nodes[i];
    EXPECT_LE(protrusion({node.hull}, subject.solid, 0.001).found, node.protrusion);
    for (int child : {node.left, node.right}) {
      if (child < 0) continue;
      ASSERT_LT(child, static_cast<int>(i));
      EXPECT_EQ(tree.nodes[static_cast<std::size_t>(child)].parent, static_cast<int>(i));
      EXPECT_LE(tree.nodes[static_cast<std::size_t>(child)].protrusion, node.protrusion);
    }
  }
}

TEST(TreeBuilding, CanBeCancelled) {
  Subject subject(uChannel(), 0.05);
  SurfaceGroups groups(subject.leaves(), 0, subject.oracle, 0);
  const Cover cover = groups.leaves();
  subject.control.cancel();
  EXPECT_THROW(treeAbove(cover, subject.oracle, TreeBounds::kProved, [](double) {}), Error);
}

}  // namespace
}  // namespace collision_hulls
