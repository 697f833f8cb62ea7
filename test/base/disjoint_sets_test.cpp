#include "base/disjoint_sets.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(DisjointSets, FindsTheLowestMember) {
  DisjointSets sets(6);
  sets.join(4, 2);
  sets.join(5, 4);
  sets.join(1, 3);
  const int lowest[] = {0, 1, 2, 1, 2, 2};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(sets.find(i), lowest[i]) << i;
  sets.join(5, 3);
  for (int i = 1; i < 6; ++i) EXPECT_EQ(sets.find(i), 1) << i;
}

}  // namespace
}  // namespace collision_hulls
