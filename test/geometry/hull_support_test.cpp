#include "geometry/hull_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

double furthest(const ConvexHull& hull, const Vector3d& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector3d& v : hull.vertices) most = std::max(most, direction.dot(v));
  return most;
}

/// From every start and in many directions: as far as a search over all vertices.
void expectSupport(const ConvexHull& hull, std::uint32_t seed) {
  const HullSupport support(hull);
  test_shapes::RandomPoints random(seed);
  for (int start = 0; start < static_cast<int>(hull.vertices.size()); ++start) {
    const Vector3d direction = random.onSphere();
    const int v = support.furthest(direction, start);
    EXPECT_NEAR(direction.dot(hull.vertices[static_cast<std::size_t>(v)]), furthest(hull, direction), 1e-9);
  }
}

TEST(HullSupport, Box) {
  const ConvexHull box = convexHull(test_shapes::box(1, 2, 3).vertices);
  const HullSupport support(box);
  for (int start = 0; start < 8; ++start)
    EXPECT_EQ(box.vertices[static_cast<std::size_t>(support.furthest({1, 1, 1}, start))], Vector3d(1, 2, 3));
}

TEST(HullSupport, RoundAndFlatHulls) {
  expectSupport(convexHull(test_shapes::sphere(1, 12).vertices), 1);
  expectSupport(convexHull(test_shapes::flange().vertices), 2);
  expectSupport(convexHull(test_shapes::sheet(1, 2, 5).vertices), 3);
}

TEST(HullSupport, RandomHulls) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    test_shapes::RandomPoints random(seed);
    expectSupport(convexHull(random.cloud(4 + 5 * seed)), seed);
  }
}

}  // namespace
}  // namespace collision_hulls
