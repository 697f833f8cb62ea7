#include "decompose/hulls_of_tree.h"

#include <gtest/gtest.h>

#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/measure/measures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

class HullsOfTree : public testing::Test {
 protected:
  Decomposition at(double tolerance, int max_hulls = 0, int max_vertices = 0) const {
    DecomposeOptions options;
    options.tolerance = tolerance;
    options.max_hulls = max_hulls;
    options.max_vertices = max_vertices;
    return hullsOfTree(tree_, options);
  }

  const TriangleMesh mesh_ = test_shapes::torus(1, 0.3, 24, 12);
  const HullTree tree_ = [&] {
    DecomposeOptions options;
    options.tolerance = 0.05;
    return hullTree(repair(mesh_), options);
  }();
};

TEST_F(HullsOfTree, ALargerToleranceTakesFewerHullsThatStillCover) {
  const Decomposition fine = at(0.05), coarse = at(0.3), one = at(10);
  EXPECT_GT(fine.hulls.size(), coarse.hulls.size());
  EXPECT_GT(coarse.hulls.size(), 1u);
  EXPECT_EQ(one.hulls.size(), 1u);
  for (const Decomposition* made : {&fine, &coarse, &one}) {
    EXPECT_FALSE(made->capped);
    EXPECT_LE(uncovered(mesh_, made->hulls), 1e-12);
  }
}

TEST_F(HullsOfTree, ALimitOnTheirNumberMakesThemCoarser) {
  const Decomposition limited = at(0.05, 2);
  EXPECT_EQ(limited.hulls.size(), 2u);
  EXPECT_TRUE(limited.capped);
  EXPECT_LE(uncovered(mesh_, limited.hulls), 1e-12);
}

TEST_F(HullsOfTree, ALimitOnVerticesKeepsTheTolerance) {
  const Solid solid(repair(mesh_));
  const Decomposition limited = at(0.3, 0, 16);
  for (const ConvexHull& hull : limited.hulls) EXPECT_LE(hull.vertices.size(), 16u);
  EXPECT_LE(uncovered(mesh_, limited.hulls), 1e-12);
  EXPECT_LE(protrusion(limited.hulls, solid, 0.001).bound, 0.301);
}

TEST_F(HullsOfTree, ACutterGivesTheSameHullsInAnyOrderOfTolerances) {
  TreeCutter cutter(tree_, 16);
  for (const double tolerance : {0.3, 0.05, 10.0, 0.3}) {
    const Decomposition once = at(tolerance, 0, 16);
    const TreeCutter::Cut cut = cutter.cut(tolerance, 0);
    ASSERT_EQ(once.hulls.size(), cut.nodes.size());
    for (std::size_t i = 0; i < cut.nodes.size(); ++i) EXPECT_EQ(once.hulls[i].vertices, cutter.hull(cut.nodes[i]).vertices);
  }
}

TEST_F(HullsOfTree, ACuttersBoundIsOfTheReducedHulls) {
  const Solid solid(repair(mesh_));
  TreeCutter cutter(tree_, 16);
  for (const double tolerance : {0.1, 0.3}) {
    const TreeCutter::Cut cut = cutter.cut(tolerance, 0);
    std::vector<ConvexHull> hulls;
    for (const int node : cut.nodes) hulls.push_back(cutter.hull(node));
    EXPECT_LE(protrusion(hulls, solid, 0.001).found, cut.bound);
    for (const int node : cut.nodes) EXPECT_LE(tree_.nodes[static_cast<std::size_t>(node)].protrusion, cut.bound);
  }
}

TEST_F(HullsOfTree, CutsChangeAtTheBoundsOfMergedHulls) {
  TreeCutter cutter(tree_, 0);
  for (const double bound : cutter.mergedBounds())
    EXPECT_LT(cutter.cut(bound, 0).nodes.size(), cutter.cut(0.999999 * bound, 0).nodes.size()) << bound;
}

TEST(FirstAim, IsThatOfTheLeastToleranceForIt) {
  for (const double margin : {0.0, 1e-6, 1e-3})
    for (const double tolerance : {0.001, 0.01}) EXPECT_NEAR(tolerance, toleranceForAim(firstAim(tolerance, margin), margin), 1e-12);
}

}  // namespace
}  // namespace collision_hulls
