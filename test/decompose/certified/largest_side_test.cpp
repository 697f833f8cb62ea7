#include "decompose/certified/largest_side.h"

#include <gtest/gtest.h>

#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

std::optional<HalfSpace> largestSideOf(const TriangleMesh& mesh, double tolerance) {
  Subject subject(mesh, tolerance);
  return largestSide(subject.mesh.mesh, subject.oracle);
}

TEST(LargestSide, NoneIfNothingFits) {
  EXPECT_FALSE(largestSideOf({{{1, 2, 3}}, {{{0, 0, 0}}}}, 0.02));
  EXPECT_FALSE(largestSideOf(torus(1, 0.1, 40, 12), 0.02));
}

TEST(LargestSide, NoneForLargePieces) {
  for (const int steps : {8, 80}) {
    const TriangleMesh mesh = lBracket(1, 0.1, 1, steps);
    ASSERT_EQ(mesh.vertices.size() > 4000, steps == 80);
    EXPECT_EQ(largestSideOf(mesh, 0.02).has_value(), steps == 8);
  }
}

/// A column on a wide foot: the column may take along a little of the foot, as deep as the tolerance allows and no more.
TEST(LargestSide, ExtendsAsFarAsItsHullFits) {
  const double tolerance = 0.05;
  const TriangleMesh mesh = merged({box(1, 1, 0.1), moved(box(0.2, 0.2, 4), {0.4, 0.4, 0.1})});
  Subject subject(mesh, tolerance);
  const std::optional<HalfSpace> plane = largestSide(subject.mesh.mesh, subject.oracle);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->normal, Eigen::Vector3d(0, 0, -1));
  EXPECT_NEAR(-plane->offset, 0.1, 0.05);
  const std::vector<SurfacePiece> parts = parted(subject.mesh.mesh, *plane, 1e-9);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(subject.oracle.fits(convexHull(parts[0].vertices)));
  EXPECT_GT(area(parts[0]), 0.5 * area(subject.mesh.mesh));
}

}  // namespace
}  // namespace collision_hulls
