// The depth of the deepest notch, the paper's straight-line concavity, against closed forms.
#include "decompose/acd/notches.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::lBracket;

constexpr double kRounding = 1e-9;

double concavity(const TriangleMesh& mesh, bool two_sided = false) {
  return deepestNotch(mesh, convexHull(mesh.vertices), two_sided, {}).concavity;
}

TEST(Notches, ConvexShapesHaveNone) {
  EXPECT_EQ(concavity(test_shapes::singleTriangle()), 0);
  EXPECT_EQ(concavity(test_shapes::singleTriangle(), true), 0);
  EXPECT_EQ(concavity(test_shapes::box(1, 2, 3, 4)), 0);
  EXPECT_EQ(concavity(test_shapes::sphere()), 0);
}

TEST(Notches, LBracketsNotchBelowItsBridge) {
  // The bridge is the plane from (leg, t) to (t, leg), the notch at (t, t).
  EXPECT_NEAR(concavity(lBracket(1, 0.1, 1)), 0.9 / std::sqrt(2), kRounding);
  EXPECT_NEAR(concavity(lBracket(1, 0.1, 1, 5)), 0.9 / std::sqrt(2), kRounding);
}

TEST(Notches, UChannelsNotchesBelowItsOpening) {
  // The end faces contain the notches' ends but are not bridges: the notches do not open towards them.
  EXPECT_NEAR(concavity(test_shapes::uChannel(3, 1, 0.1, 2)), 0.9, kRounding);
}

TEST(Notches, ASheetsRidgeIsANotchFromBelow) {
  test_shapes::MeshBuilder builder;
  builder.quad({-1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {-1, 1, 0});
  builder.quad({0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1});
  TriangleMesh roof = builder.mesh();
  for (Triangle& t : roof.triangles) std::swap(t[1], t[2]);  // whichever way it faces
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_NEAR(concavity(roof, true), 1, kRounding);
    for (Triangle& t : roof.triangles) std::swap(t[1], t[2]);
  }
}

}  // namespace
}  // namespace collision_hulls
