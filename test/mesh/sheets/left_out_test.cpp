#include "mesh/sheets/left_out.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

std::vector<char> leftOut(const std::vector<std::vector<int>>& edges, const std::vector<double>& areas) {
  const RunControl control;
  Looks look(control);
  return leftOut(edges, areas, look);
}

TEST(LeftOut, TheSmallestOfThreeThatMeet) {
  EXPECT_EQ(leftOut({{0, 1, 2}, {0, 1, 2}}, {9, 2, 1}), (std::vector<char>{0, 0, 1}));
  EXPECT_EQ(leftOut({{0, 1, 2}, {0, 1, 2}}, {9, 1, 2}), (std::vector<char>{0, 1, 0}));
  EXPECT_EQ(leftOut({{0, 1, 2}, {0, 1, 2}}, {0.5, 1, 2}), (std::vector<char>{1, 0, 0}));
}

TEST(LeftOut, NothingWhereNoEdgeIsOdd) {
  EXPECT_EQ(leftOut({{0, 1}, {0, 1, 2, 3}, {}}, {4, 3, 2, 1}), (std::vector<char>{0, 0, 0, 0}));
}

TEST(LeftOut, NothingThatMakesAsManyEdgesOdd) {
  EXPECT_EQ(leftOut({{0, 1, 2}, {2, 3}}, {3, 2, 1, 4}), (std::vector<char>{0, 1, 0, 0}));  // not 2, the smallest
}

TEST(LeftOut, WallsThatLeanOnEachOther) {
  // 1 and 2 meet at the last edge, which is even with both and without both.
  EXPECT_EQ(leftOut({{0, 1, 3}, {0, 1, 3}, {0, 2, 4}, {0, 2, 4}, {1, 2}}, {9, 1, 2, 3, 4}), (std::vector<char>{0, 1, 1, 0, 0}));
}

TEST(LeftOut, ASmallOneThatHelpsOnlyOnceALargerOneIsGone) {
  // 0 keeps the first edge even until 1 is left out, for the sake of the others.
  EXPECT_EQ(leftOut({{0, 1}, {1, 2, 3}, {1, 2, 3}, {2, 3}}, {1, 2, 3, 4}), (std::vector<char>{1, 1, 0, 0}));
}

TEST(LeftOut, OneIsPutBackOnceALargerOneIsGone) {
  // 0 and 1 are what 2 covers alone: 0 goes first, as the smallest, then 2, and then 0 is needed.
  EXPECT_EQ(leftOut({{0, 2, 3}, {0, 2, 3}, {0, 1}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {1, 5, 3, 9}), (std::vector<char>{0, 0, 1, 0}));
}

}  // namespace
}  // namespace collision_hulls
