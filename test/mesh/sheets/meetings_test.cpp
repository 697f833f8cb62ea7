#include "mesh/sheets/meetings.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "shapes.h"

namespace collision_hulls {
namespace {

/// Three triangles at the edge from 0 to 1. The second uses it the other way.
TriangleMesh threeAtAnEdge() {
  test_shapes::MeshBuilder builder;
  builder.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  builder.triangle({1, 0, 0}, {0, 0, 0}, {0, 0, 1});
  builder.triangle({0, 0, 0}, {1, 0, 0}, {0, -1, 0});
  return builder.mesh();
}

struct Oriented {
  explicit Oriented(TriangleMesh m) : mesh(std::move(m)), edges(findEdges(mesh.triangles, mesh.vertices.size(), control)) {
    patches = orient(mesh, edges, control);
  }

  const RunControl control;
  Looks look{control};
  TriangleMesh mesh;
  Edges edges;
  OrientedPatches patches;
};

TEST(Meetings, AreWhereMoreThanTwoTrianglesMeet) {
  Oriented oriented(threeAtAnEdge());
  int edges = 0;
  Meetings(oriented.mesh, oriented.edges, oriented.patches, oriented.look).forEach([&](const Meetings::Halves& here) {
    ++edges;
    ASSERT_EQ(here.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(here[i].half_edge / 3, static_cast<int>(i));
      EXPECT_EQ(here[i].patch, static_cast<int>(i));
      EXPECT_EQ(here[i].direction, i == 1 ? -1 : 1);
    }
    EXPECT_EQ(sumOfDirections(here), 1);
  });
  EXPECT_EQ(edges, 1);
}

/// Of each edge, without the patch `left_out`.
std::vector<int> sums(Oriented& oriented, int left_out = -1) {
  std::vector<int> result;
  Meetings(oriented.mesh, oriented.edges, oriented.patches, oriented.look)
      .forEach([&](const MeetingHalf& half) { return half.patch == left_out; },
               [&](const Meetings::Halves& here) { result.push_back(sumOfDirections(here)); });
  return result;
}

TEST(Meetings, AsTheTrianglesAreTurned) {
  Oriented oriented(threeAtAnEdge());
  EXPECT_EQ(sums(oriented), std::vector<int>{1});
  oriented.patches.turn = {1, 0, 0};
  EXPECT_EQ(sums(oriented), std::vector<int>{-1});
}

TEST(Meetings, WithoutWhatIsLeftOut) {
  Oriented oriented(threeAtAnEdge());
  EXPECT_EQ(sums(oriented, 0), std::vector<int>{0});
  EXPECT_EQ(sums(oriented, 1), std::vector<int>{2});
  oriented.patches.patch = {0, 0, 0};
  EXPECT_EQ(sums(oriented, 0), std::vector<int>{});
}

TEST(Meetings, NoneInABox) {
  Oriented oriented(test_shapes::box(1, 1, 1));
  EXPECT_EQ(sums(oriented), std::vector<int>{});
}

}  // namespace
}  // namespace collision_hulls
