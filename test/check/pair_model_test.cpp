#include "check/pair_model.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

/// The corners of each triangle for itself, and vertices that none uses.
TriangleMesh separated(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const int first = static_cast<int>(result.vertices.size());
    for (int k = 0; k < 3; ++k) result.vertices.push_back(mesh.corner(t, k));
    result.vertices.emplace_back(9, 9, 9);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

TEST(PairModel, VerticesAtOnePlaceAreOne) {
  const TriangleMesh mesh = separated(test_shapes::torus());
  const std::vector<ProbeShape> boxes = boxShapes();
  ValidationPair pair;
  pair.name = "torus";
  pair.original = mesh;
  pair.hulls = {test_shapes::hullOf(mesh)};
  const PairModel model(pair, boxes, {}, {});
  EXPECT_EQ(model.original.vertices.size(), test_shapes::torus().vertices.size());
  ASSERT_EQ(model.original.triangles.size(), mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(model.original.corner(t, k), model.frame.units(mesh.corner(t, k)));
}

}  // namespace
}  // namespace collision_hulls
