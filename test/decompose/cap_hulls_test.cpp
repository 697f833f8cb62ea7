#include "decompose/cap_hulls.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

/// Unit cubes with their low corners at these places along x.
std::vector<ConvexHull> cubesAt(const std::vector<double>& places) {
  std::vector<ConvexHull> hulls;
  for (const double x : places) hulls.push_back(boxHull({x, 0, 0}, {x + 1, 1, 1}));
  return hulls;
}

TEST(CapHulls, KeepsWhatIsWithinTheLimit) {
  const std::vector<ConvexHull> hulls = cubesAt({0, 5});
  const std::vector<ConvexHull> capped = capHulls(hulls, 2, {});
  ASSERT_EQ(capped.size(), 2u);
  EXPECT_EQ(capped[1].vertices, hulls[1].vertices);
}

TEST(CapHulls, MergesThePairThatAddsLeast) {
  const std::vector<ConvexHull> capped = capHulls(cubesAt({0, 10, 11, 30}), 3, {});
  ASSERT_EQ(capped.size(), 3u);
  EXPECT_NEAR(volume(capped[1]), 2, 1e-9) << "the two cubes side by side";
  EXPECT_NEAR(volume(capped[2]), 1, 1e-9);
}

TEST(CapHulls, OneHullHoldsThemAll) {
  const std::vector<ConvexHull> hulls = cubesAt({0, 3, 7});
  const std::vector<ConvexHull> capped = capHulls(hulls, 1, {});
  ASSERT_EQ(capped.size(), 1u);
  for (const ConvexHull& hull : hulls)
    for (const Eigen::Vector3d& v : hull.vertices) EXPECT_LE(planeDistance(capped[0], v), 1e-12);
}

TEST(CapHulls, IsCancelled) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(capHulls(cubesAt({0, 1, 2}), 1, control), Error);
}

}  // namespace
}  // namespace collision_hulls
