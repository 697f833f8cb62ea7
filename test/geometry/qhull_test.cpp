#include "geometry/qhull.h"

#include <gtest/gtest.h>

#include "counted_looks.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

TEST(Qhull, CubeWithPointsInside) {
  std::vector<Vector3d> points = test_shapes::box(1, 1, 1).vertices;
  points.emplace_back(0.5, 0.5, 0.5);
  points.emplace_back(0.2, 0.3, 0.9);
  const std::optional<ConvexHull> hull = qhull(points);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->vertices.size(), 8u);
  EXPECT_EQ(hull->triangles.size(), 12u);
  EXPECT_NEAR(signedVolume(hull->vertices, hull->triangles), 1, 1e-12) << "triangles face outward";
}

TEST(Qhull, EnclosesPointsInGeneralPosition) {
  test_shapes::RandomPoints random(5);
  const std::vector<Vector3d> points = random.cloud(200);
  const std::optional<ConvexHull> hull = qhull(points);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->triangles.size(), 2 * hull->vertices.size() - 4);
  for (const Vector3d& p : points) EXPECT_LE(planeDistance(*hull, p), 1e-12);
}

TEST(Qhull, ACallerWhoIsCancelledMeanwhileDoesNotWaitForIt) {
  test_shapes::RandomPoints random(6);
  std::vector<Vector3d> points;
  for (int i = 0; i < 100'000; ++i) points.push_back(random.onSphere());
  const auto work = [&](const RunControl& control) { qhull(points, control); };
  EXPECT_EQ(looksAfterCancel(2, work), 1u) << "the first look is before Qhull starts";
  EXPECT_GT(looksOf(work), 2u);
}

}  // namespace
}  // namespace collision_hulls
