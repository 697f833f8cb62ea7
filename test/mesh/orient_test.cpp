#include "mesh/orient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "shapes.h"

namespace collision_hulls {
namespace {

OrientedPatches oriented(const TriangleMesh& mesh) {
  return orient(mesh, findEdges(mesh.triangles, mesh.vertices.size(), {}), {});
}

void flip(Triangle& triangle) {
  std::swap(triangle[1], triangle[2]);
}

TEST(Orient, AnOutwardBoxStays) {
  const OrientedPatches result = oriented(test_shapes::box(1, 2, 3));
  EXPECT_EQ(std::count(result.turn.begin(), result.turn.end(), 1), 0);
  EXPECT_EQ(result.patches, 1u);
}

TEST(Orient, AnInwardBoxIsTurned) {
  TriangleMesh box = test_shapes::box(1, 2, 3);
  for (Triangle& triangle : box.triangles) flip(triangle);
  const OrientedPatches result = oriented(box);
  EXPECT_EQ(std::count(result.turn.begin(), result.turn.end(), 1), 12);
}

TEST(Orient, TheSmallerPartIsTurned) {
  TriangleMesh box = test_shapes::box(1, 1, 1);
  flip(box.triangles[3]);
  flip(box.triangles[8]);
  const OrientedPatches result = oriented(box);
  for (std::size_t t = 0; t < box.triangles.size(); ++t) EXPECT_EQ(result.turn[t], t == 3 || t == 8) << t;
}

TEST(Orient, AFlatSheetStaysAsItIs) {
  TriangleMesh sheet = test_shapes::sheet(1, 1, 2);
  for (Triangle& triangle : sheet.triangles) flip(triangle);
  const OrientedPatches result = oriented(sheet);
  EXPECT_EQ(std::count(result.turn.begin(), result.turn.end(), 1), 0);
}

}  // namespace
}  // namespace collision_hulls
