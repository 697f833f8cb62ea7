#include "decompose/cluster_hulls.h"

#include <gtest/gtest.h>

#include <numeric>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;
using Eigen::Vector3d;

TEST(ClusterHulls, OneForEachCluster) {
  const RepairedMesh mesh = repair(merged({box(1, 1, 1), moved(box(1, 1, 1), {3, 0, 0})}));
  std::vector<int> first(12), second(12);
  std::iota(first.begin(), first.end(), 0);
  std::iota(second.begin(), second.end(), 12);
  const std::vector<ConvexHull> hulls = clusterHulls(mesh, {first, second}, {});
  ASSERT_EQ(hulls.size(), 2u);
  EXPECT_NEAR(volume(hulls[0]), 1, 1e-12);
  EXPECT_NEAR(boundingBox(hulls[1]).min().x(), 3, 1e-12);
}

TEST(AddLoose, ASegmentOutsideGoesToTheNearestHull) {
  std::vector<ConvexHull> hulls{boxHull({0, 0, 0}, {1, 1, 1}), boxHull({3, 0, 0}, {4, 1, 1})};
  addLoose(hulls, loosePoints({{4.2, 0.5, 0.5}, {0.5, 0.5, 0.5}}), {});
  EXPECT_NEAR(volume(hulls[0]), 1, 1e-12) << "a point inside changes nothing";
  EXPECT_GT(volume(hulls[1]), 1);
  EXPECT_TRUE(holds(hulls[1], {4.2, 0.5, 0.5}));
}

TEST(ClusterHulls, LooseSegmentsAloneGetAHull) {
  RepairedMesh mesh;
  mesh.loose = loosePoints({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const std::vector<ConvexHull> hulls = clusterHulls(mesh, {}, {});
  ASSERT_EQ(hulls.size(), 1u);
  EXPECT_NEAR(volume(hulls[0]), 1.0 / 6, 1e-12);
}

}  // namespace
}  // namespace collision_hulls
