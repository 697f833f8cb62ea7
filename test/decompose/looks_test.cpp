// How often the making of hulls looks at its control: a hull may have as many vertices as the mesh.
#include <gtest/gtest.h>

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "collision_hulls/decompose/round_outward.h"
#include "collision_hulls/mesh/repair.h"
#include "counted_looks.h"
#include "decompose/bounding_box.h"
#include "decompose/cap_hulls.h"
#include "decompose/padding.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

/// All of its 10,242 vertices are corners of its hull.
const TriangleMesh& ball() {
  static const TriangleMesh mesh = test_shapes::sphere(1, 32);
  return mesh;
}

const ConvexHull& hullOfBall() {
  static const ConvexHull hull = convexHull(ball().vertices);
  return hull;
}

std::size_t vertices() {
  return hullOfBall().vertices.size();
}

std::size_t looksOfHull() {
  return looksOf([](const RunControl& control) { convexHull(ball().vertices, control); });
}

TEST(LooksOfHulls, TheBallIsLargeEnoughToTell) {
  EXPECT_GT(vertices(), 20 * kLargeItemsBetweenLooks);
  EXPECT_GT(looksOfHull(), 40u);
}

TEST(LooksOfHulls, ASingleHull) {
  const RepairedMesh mesh = repair(ball());
  DecomposeOptions options;
  options.method = Method::kSingleHull;
  options.max_vertices = 0;
  EXPECT_GE(looksOf([&](const RunControl& control) { decompose(mesh, options, control); }), looksOfHull());
}

TEST(LooksOfHulls, FewerVertices) {
  const std::size_t held = vertices() / kLargeItemsBetweenLooks;  // by the reduced hull, which is compared with all
  EXPECT_GE(looksOf([](const RunControl& control) { capped(hullOfBall(), 64, control); }), held);
  EXPECT_GE(looksOf([](const RunControl& control) { hullHolding(test_shapes::box(9, 9, 9).vertices, hullOfBall().vertices, control); }),
            1 + held);
  EXPECT_GE(looksOf([](const RunControl& control) { addedDistance(hullOfBall(), hullOfBall(), control); }), vertices());
}

TEST(LooksOfHulls, RoundingOutward) {
  const auto rounded = [](const RunControl& control) { roundOutward({hullOfBall()}, ball(), 0, 0, control); };
  EXPECT_GE(looksOf(rounded), vertices() + looksOfHull()) << "holding all, and the hull of what has grown";
  for (const std::size_t at : {1u, 30u, 100u, 1000u}) EXPECT_EQ(looksAfterCancel(at, rounded), 1u) << at;
}

TEST(LooksOfHulls, PaddingAndMerging) {
  EXPECT_GE(looksOf([](const RunControl& control) { padded(hullOfBall(), 0.1, 0, control); }), 2 * looksOfHull());
  EXPECT_GE(looksOf([](const RunControl& control) { capHulls({hullOfBall(), hullOfBall()}, 1, control); }), looksOfHull());
}

}  // namespace
}  // namespace collision_hulls
