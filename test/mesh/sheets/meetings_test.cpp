#include "mesh/sheets/meetings.h"

#include <gtest/gtest.h>

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

TEST(Meetings, AsTheTrianglesAreTurned) {
  Oriented oriented(threeAtAnEdge());
  oriented.patches.turn = {1, 0, 0};
  Meetings(oriented.mesh, oriented.edges, oriented.patches, oriented.look).forEach([](const Meetings::Halves& here) {
    EXPECT_EQ(sumOfDirections(here), -1);
  });
}

TEST(Meetings, WithoutWhatIsLeftOut) {
  Oriented oriented(threeAtAnEdge());
  const Meetings meetings(oriented.mesh, oriented.edges, oriented.patches, oriented.look);
  meetings.forEach([](const MeetingHalf& half) { return half.patch == 1; },
                   [](const Meetings::Halves& here) { EXPECT_EQ(sumOfDirections(here), 2); });
  meetings.forEach([](const MeetingHalf&) { return true; }, [](const Meetings::Halves&) { ADD_FAILURE() << "nothing is left"; });
}

TEST(Meetings, NoneInABox) {
  Oriented oriented(test_shapes::box(1, 1, 1));
  Meetings(oriented.mesh, oriented.edges, oriented.patches, oriented.look).forEach([](const Meetings::Halves&) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace collision_hulls
