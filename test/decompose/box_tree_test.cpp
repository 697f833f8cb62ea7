#include "decompose/box_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "random_points.h"

namespace collision_hulls {
namespace {

using Tree = BoxTree<3, 4>;

/// The least distance to a key, and how many keys were compared.
std::pair<double, int> nearest(const Tree& tree, const std::vector<Eigen::Vector3d>& keys, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  int compared = 0;
  tree.search([&](const Tree::Box& box) { return box.exteriorDistance(p); },
              [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i, ++compared)
                  least = std::min(least, (keys[static_cast<std::size_t>(tree.order()[i])] - p).norm());
                return least;
              },
              least);
  return {least, compared};
}

TEST(BoxTree, FindsTheLeastValueAmongFewItems) {
  test_shapes::RandomPoints random(5);
  for (const int count : {1, 4, 5, 8, 9, 1000}) {
    const std::vector<Eigen::Vector3d> keys = random.cloud(count);
    const Tree tree(keys);
    for (const Eigen::Vector3d& p : random.cloud(50)) {
      double expected = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector3d& key : keys) expected = std::min(expected, (key - p).norm());
      const auto [least, compared] = nearest(tree, keys, p);
      EXPECT_EQ(least, expected);
      EXPECT_LE(compared, 200);
    }
  }
}

TEST(BoxTree, HoldsEachItemOnceAndItsBoxHoldsAll) {
  const std::vector<Eigen::Vector3d> keys = test_shapes::RandomPoints(6).cloud(77);
  const Tree tree(keys);
  EXPECT_EQ(std::set<int>(tree.order().begin(), tree.order().end()).size(), keys.size());
  for (const Eigen::Vector3d& key : keys) EXPECT_TRUE(tree.box().contains(key));
}

TEST(BoxTree, EqualItemsAndNoneAtAll) {
  const std::vector<Eigen::Vector3d> same(20, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(nearest(Tree(same), same, Eigen::Vector3d(1, 2, 5)), std::make_pair(2.0, 20));
  EXPECT_EQ(nearest(Tree(), {}, Eigen::Vector3d::Zero()).second, 0);
}

}  // namespace
}  // namespace collision_hulls
