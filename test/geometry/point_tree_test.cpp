#include "geometry/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

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

TEST(PointTree, FindsTheNearestOfThoseAccepted) {
  RandomPoints random(6);
  for (const int count : {0, 1, 16, 17, 1000}) {
    const std::vector<Eigen::Vector3d> points = random.cloud(count);
    const PointTree tree(points);
    for (const Eigen::Vector3d& p : random.cloud(50)) {
      std::optional<std::size_t> expected;
      const double limit = 0.5 * p.norm();
      for (std::size_t i = 1; i < points.size(); i += 2)  // odd ones
        if ((points[i] - p).norm() < (expected ? (points[*expected] - p).norm() : limit)) expected = i;
      EXPECT_EQ(tree.nearest(p, limit, points.size(), [](std::size_t i) { return i % 2 == 1; }), expected) << count;
    }
    std::size_t asked = 0;
    EXPECT_FALSE(tree.nearest({0, 0, 0}, 100, 5, [&](std::size_t) { return ++asked, false; }));
    EXPECT_EQ(asked, std::min<std::size_t>(5, points.size()));
  }
}

}  // namespace
}  // namespace collision_hulls
