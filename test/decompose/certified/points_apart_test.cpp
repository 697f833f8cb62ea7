#include "decompose/certified/points_apart.h"

#include <gtest/gtest.h>

#include "decompose/certified/merging.h"
#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

/// Each mesh becomes the leaf of one group.
Cover coverOf(Subject& subject, const std::vector<TriangleMesh>& parts) {
  std::vector<Leaf> leaves;
  for (const TriangleMesh& part : parts) leaves.push_back(leafOf(part));
  return SurfaceGroups(leaves, 0, subject.oracle, 0).leaves();
}

TEST(PointsApart, OneGroupIsMinimal) {
  Subject subject(box(1, 1, 1), 0.05);
  EXPECT_TRUE(isLeast(coverOf(subject, {box(1, 1, 1)}), subject.mesh.mesh, subject.solid, 0.05));
}

TEST(PointsApart, HalvesOfABoxAreNotMinimal) {
  Subject subject(box(2, 1, 1), 0.05);
  EXPECT_FALSE(isLeast(coverOf(subject, {box(1, 1, 1), moved(box(1, 1, 1), {1, 0, 0})}), subject.mesh.mesh, subject.solid, 0.05));
}

TEST(PointsApart, ThreeWallsOfAChannelAreMinimal) {
  Subject subject(uChannel(1, 1, 0.1, 2, 2), 0.05);
  SurfaceGroups groups(subject.leaves(), 0, subject.oracle, 0);
  const Cover cover = mergedBest(groups.leaves(), groups);
  ASSERT_EQ(cover.size(), 3u);
  EXPECT_TRUE(isLeast(cover, subject.mesh.mesh, subject.solid, 0.05));
  EXPECT_FALSE(isLeast(cover, subject.mesh.mesh, subject.solid, 0.6));  // one hull may well contain all of it
}

TEST(PointsApart, BoxesWithASmallGap) {
  const std::vector<TriangleMesh> boxes{box(1, 1, 1), moved(box(1, 1, 1), {1.3, 0, 0})};
  Subject subject(test_shapes::merged(boxes), 0.1);
  EXPECT_TRUE(isLeast(coverOf(subject, boxes), subject.mesh.mesh, subject.solid, 0.1));
  EXPECT_FALSE(isLeast(coverOf(subject, boxes), subject.mesh.mesh, subject.solid, 0.2));
}

TEST(PointsApart, SkipsManyGroups) {
  std::vector<TriangleMesh> boxes;
  for (int i = 0; i < 20; ++i) boxes.push_back(moved(box(1, 1, 1), {3.0 * i, 0, 0}));
  Subject subject(test_shapes::merged(boxes), 0.1);
  EXPECT_FALSE(isLeast(coverOf(subject, boxes), subject.mesh.mesh, subject.solid, 0.1));
}

}  // namespace
}  // namespace collision_hulls
