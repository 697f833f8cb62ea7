#include "geometry/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_points.h"

namespace collision_hulls {
namespace {

using test_shapes::RandomPoints;

TEST(PointTree, AgreesWithTestingEveryPoint) {
  RandomPoints random(5);
  for (const int count : {1, 15, 16, 17, 33, 1000}) {
    const std::vector<Eigen::Vector3d> points = random.cloud(count), planes = random.cloud(50);
    const PointTree tree(points);
    int beyond = 0;
    for (const Eigen::Vector3d& p : planes) {
      const HalfSpace plane{p.normalized(), 2 * p.norm()};
      for (const double margin : {0.0, 0.1, -0.3}) {
        const bool expected = std::any_of(points.begin(), points.end(), [&](const auto& q) { return plane.distance(q) > margin; });
        EXPECT_EQ(tree.anyBeyond(plane, margin), expected);
        beyond += expected;
      }
    }
    EXPECT_TRUE(0 < beyond && beyond < 150) << beyond;
  }
}

}  // namespace
}  // namespace collision_hulls
