#include "geometry/box_hull.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(HullOfBox, LiesBetweenItsCorners) {
  const Eigen::Vector3d low(-1, 2, 3), high(4, 5, 7);
  const ConvexHull hull = hullOfBox(low, high);
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(hull.faces.size(), 6u);
  EXPECT_EQ(boundingBox(hull).min(), low);
  EXPECT_EQ(boundingBox(hull).max(), high);
  EXPECT_NEAR(volume(hull), 5 * 3 * 4, 1e-12);
}

TEST(HullOfBox, IsAboutTheOriginIfOnlyItsSidesAreGiven) {
  const ConvexHull hull = hullOfBox(Eigen::Vector3d(2, 4, 0.1));
  EXPECT_EQ(boundingBox(hull).min(), Eigen::Vector3d(-1, -2, -0.05));
  EXPECT_EQ(boundingBox(hull).max(), Eigen::Vector3d(1, 2, 0.05));
}

TEST(HullOfBox, OfNoWidthIsAPlate) {
  EXPECT_GT(hullOfBox(Eigen::Vector3d(1, 1, 0)).thickness, 0);
}

}  // namespace
}  // namespace collision_hulls
