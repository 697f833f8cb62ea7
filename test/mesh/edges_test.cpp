#include "mesh/edges.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace collision_hulls {
namespace {

TEST(Edges, OfAClosedMeshPairUp) {
  const TriangleMesh box = test_shapes::box(1, 1, 1, 2);
  const Edges edges = findEdges(box.triangles, box.vertices.size(), {});
  EXPECT_EQ(edges.open, 0u);
  EXPECT_EQ(edges.nonmanifold, 0u);
  EXPECT_EQ(edges.components, 1u);
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    const int twin = edges.twin[static_cast<std::size_t>(h)];
    ASSERT_GE(twin, 0);
    EXPECT_EQ(edges.twin[static_cast<std::size_t>(twin)], h);
    EXPECT_EQ(startOf(box.triangles, h), endOf(box.triangles, twin));
  }
}

TEST(Edges, OfASheetAreOpen) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 3);
  const Edges edges = findEdges(sheet.triangles, sheet.vertices.size(), {});
  EXPECT_EQ(edges.open, 12u);
  EXPECT_EQ(edges.components, 1u);
}

TEST(Edges, ThreeTrianglesAtOneEdge) {
  const Edges edges = findEdges({{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}, 5, {});
  EXPECT_EQ(edges.nonmanifold, 1u);
  EXPECT_EQ(edges.open, 6u);
  EXPECT_EQ(edges.twin[0], Edges::kNonManifold);
  EXPECT_EQ(edges.twin[1], Edges::kOpen);
  EXPECT_EQ(edges.components, 1u) << "they are connected";
}

TEST(Edges, TrianglesThatMeetInACornerAreApart) {
  const Edges edges = findEdges({{0, 1, 2}, {2, 3, 4}}, 5, {});
  EXPECT_EQ(edges.components, 2u);
  EXPECT_EQ(edges.component, (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace collision_hulls
