#include "measure/halves_by_place.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using Indices = std::vector<std::size_t>;
using test_shapes::boxHull;

TEST(HalvesByPlace, DivideAcrossTheLongestSide) {
  std::vector<ConvexHull> hulls;
  for (const double x : {5.0, 1.0, 9.0, 3.0, 7.0}) hulls.push_back(boxHull({0, x, x / 2}, {1, x + 1, x / 2 + 1}));
  EXPECT_EQ(halvesByPlace(hulls, {0, 1, 2, 3, 4}), std::make_pair(Indices({1, 3}), Indices({0, 4, 2})));
  EXPECT_EQ(halvesByPlace(hulls, {4, 0, 2}), std::make_pair(Indices({0}), Indices({4, 2})));
}

TEST(HalvesByPlace, HullsInOnePlaceAreDividedAsWell) {
  const std::vector<ConvexHull> hulls(4, boxHull({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(halvesByPlace(hulls, {3, 0, 2, 1}), std::make_pair(Indices({3, 0}), Indices({2, 1})));
}

}  // namespace
}  // namespace collision_hulls
