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

}  // namespace
}  // namespace collision_hulls
