#include "decompose/coarser/coarser_cuts.h"

#include <gtest/gtest.h>

#include "decompose/coarser/coarser_hulls.h"
#include "decompose/hulls_of_tree.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

/// Three unit boxes in a row, the second pair further apart.
HullTree rowOfBoxes() {
  std::vector<ConvexHull> boxes;
  for (const double x : {0.0, 1.2, 4.0}) boxes.push_back(convexHull(test_shapes::moved(test_shapes::box(1, 1, 1), {x, 0, 0}).vertices));
  return coarserHulls(boxes, 0.01);
}

std::vector<ConvexHull> hullsAt(double tolerance, const HullTree& tree) {
  DecomposeOptions options;
  options.tolerance = tolerance;
  return hullsOfTree(tree, options).hulls;
}

std::shared_ptr<const HullTree> above(const HullTree& tree, const std::vector<ConvexHull>& hulls, double tolerance, double margin = 0) {
  return coarserCuts(tree, {hulls, 0.015, tolerance, 0, 64, margin, 0});
}

TEST(CoarserCuts, AllAboveTheLeaves) {
  const HullTree tree = rowOfBoxes();
  const std::vector<ConvexHull> hulls = hullsAt(0.02, tree);
  ASSERT_EQ(3u, hulls.size());
  const auto cuts = above(tree, hulls, 0.02);
  ASSERT_TRUE(cuts);
  ASSERT_EQ(5u, cuts->nodes.size());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(hulls[i].vertices, cuts->nodes[i].hull.vertices) << "as written, in their order";
    EXPECT_EQ(0.015, cuts->nodes[i].protrusion);
  }
  EXPECT_EQ(tree.nodes[3].protrusion, cuts->nodes[3].protrusion);
  EXPECT_EQ(tree.nodes[4].protrusion, cuts->nodes[4].protrusion);
  EXPECT_TRUE(cuts->isCut(cuts->cutAt(tree.nodes[3].protrusion)));
  EXPECT_EQ(2u, cuts->cutAt(tree.nodes[3].protrusion).size());
  EXPECT_EQ(-1, cuts->nodes[4].parent);
}

TEST(CoarserCuts, ACoarserResultHasFewerAbove) {
  const HullTree tree = rowOfBoxes();
  const double tolerance = 1.001 * tree.nodes[3].protrusion;
  const auto cuts = above(tree, hullsAt(tolerance, tree), tolerance);
  ASSERT_TRUE(cuts);
  EXPECT_EQ(3u, cuts->nodes.size());
}

TEST(CoarserCuts, TheMarginIsPartOfABound) {
  const HullTree tree = rowOfBoxes();
  const std::vector<ConvexHull> hulls = hullsAt(0.02, tree);
  const auto cuts = above(tree, hulls, 0.02, 1e-4);
  ASSERT_TRUE(cuts);
  EXPECT_DOUBLE_EQ(tree.nodes[4].protrusion + 1e-4, cuts->nodes[4].protrusion);
}

TEST(CoarserCuts, NoneForOtherHulls) {
  const HullTree tree = rowOfBoxes();
  std::vector<ConvexHull> hulls = hullsAt(0.02, tree);
  hulls[1] = convexHull(test_shapes::box(1, 1, 1.1).vertices);
  EXPECT_FALSE(above(tree, hulls, 0.02));
  hulls.pop_back();
  EXPECT_FALSE(above(tree, hulls, 0.02));
}

}  // namespace
}  // namespace collision_hulls
