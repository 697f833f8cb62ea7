#include "decompose/hacd/dual_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.h"

namespace collision_hulls {
namespace {

TEST(DualGraph, EmptyMesh) {
  EXPECT_TRUE(dualGraph({}).empty());
  EXPECT_TRUE(dualGraph(test_shapes::singleTriangle()).empty());
}

TEST(DualGraph, TwoTrianglesShareTheirBorder) {
  const std::vector<DualEdge> edges = dualGraph(test_shapes::sheet(3, 4));
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].v, 0);
  EXPECT_EQ(edges[0].w, 1);
  EXPECT_DOUBLE_EQ(edges[0].border, 5);
}

TEST(DualGraph, ClosedMeshHasThreeEdgesPerTwoTriangles) {
  const TriangleMesh mesh = test_shapes::torus();
  EXPECT_EQ(dualGraph(mesh).size(), mesh.triangles.size() * 3 / 2);
}

TEST(DualGraph, ComponentsAreNotConnected) {
  const TriangleMesh two = test_shapes::merged({test_shapes::singleTriangle(), test_shapes::singleTriangle()});
  EXPECT_TRUE(dualGraph(two).empty());
}

/// k triangles around one edge of length 2.
TriangleMesh fan(int k) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, -1}, {0, 0, 1}};
  for (int i = 0; i < k; ++i) {
    const double angle = 2 * test_shapes::kPi * i / k;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.triangles.push_back({0, 1, i + 2});
  }
  return mesh;
}

TEST(DualGraph, NonManifoldEdgeConnectsAllPairsAndLeavesThePerimeterOnce) {
  for (int k : {2, 3, 5, 40}) {
    const std::vector<DualEdge> edges = dualGraph(fan(k));
    if (k <= 9) {
      EXPECT_EQ(edges.size(), static_cast<std::size_t>(k * (k - 1) / 2));
    }
    double border = 0;
    for (const DualEdge& edge : edges) border += edge.border;
    EXPECT_NEAR(2 * border, 2.0 * k, 1e-12) << k << " triangles";
  }
}

}  // namespace
}  // namespace collision_hulls
