#include "decompose/certified/merging.h"

#include <gtest/gtest.h>

#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

constexpr MergeCost::Kind kKinds[]{MergeCost::kSize, MergeCost::kGrowth, MergeCost::kMeanGrowth, MergeCost::kSquares};

TEST(Merging, NoneOrOneGroup) {
  Subject subject(box(1, 1, 1), 0.05);
  SurfaceGroups groups(subject.leaves(), 0, subject.oracle, 0);
  EXPECT_TRUE(merged({}, groups, {}, Proof::kLater).empty());
  EXPECT_EQ(mergedBest(groups.leaves(), groups).size(), 1u);
}

TEST(Merging, FarApartDependsOnTheTolerance) {
  const TriangleMesh two = test_shapes::merged({box(1, 1, 1), moved(box(1, 1, 1), {1.5, 0, 0})});
  Subject subject(two, 0.2);
  SurfaceGroups groups(subject.leaves(), 0, subject.oracle, 0);
  const Cover cover = groups.leaves();
  ASSERT_EQ(cover.size(), 2u);
  EXPECT_TRUE(farApart(cover[0], cover[1], 0.2));
  EXPECT_FALSE(farApart(cover[0], cover[1], 0.3));
  EXPECT_EQ(mergedBest(cover, groups).size(), 2u);
  EXPECT_EQ(groups.evaluations(), 0);
}

TEST(Merging, PiecesOfABoxMergeWithEveryKindOfCost) {
  Subject subject(box(1, 2, 3, 3), 0.05);
  for (MergeCost::Kind kind : kKinds)
    for (Proof proof : {Proof::kLater, Proof::kAtOnce}) {
      SurfaceGroups groups({leafOf(subject.mesh.mesh)}, 16, subject.oracle, 0);
      const Cover cover = merged(singlesOf(groups, 16), groups, {kind, 0, 0}, proof);
      EXPECT_LT(cover.size(), 16u) << "kind " << kind;
      EXPECT_EQ(elementsIn(cover), upTo(16));
    }
}

TEST(Merging, GivesNoMoreGroupsAllProven) {
  constexpr std::size_t kElements = 40;
  for (const TriangleMesh& mesh : {uChannel(1, 1, 0.1, 2, 2), torus(1, 0.3, 16, 8), flange(3, 0.4, 1, 0.12, 0.15, 2, 1)}) {
    SCOPED_TRACE(testing::Message() << mesh.triangles.size() << " triangles");
    Subject subject(mesh, 0.05 * diagonal(mesh));
    const std::vector<Leaf> leaves = subject.leaves();
    SurfaceGroups groups(leaves, kElements, subject.oracle, 0);
    const std::size_t elements = groups.leaves().size() < kElements ? kElements : leaves.size();
    const Cover cover = mergedBest(groups.leaves(), groups);
    EXPECT_LE(cover.size(), leaves.size());
    EXPECT_EQ(elementsIn(cover), upTo(elements));
    EXPECT_TRUE(groups.proven(cover));
    const std::vector<ConvexHull> hulls = exactHulls(cover, groups);
    EXPECT_LE(uncovered(subject.mesh.mesh, hulls), 1e-12 * diagonal(mesh));
    EXPECT_LE(subject.protrusionOf(hulls), subject.oracle.tolerance());
  }
}

/// The tolerance is slightly below the depth of holes; there, the oracle's quick answer accepts what a proof rejects.
TEST(Merging, RefutedUnionsFallBackIntoTheirParts) {
  const TriangleMesh mesh = flange(7, 0.4, 1, 0.12, 0.4, 4, 2);
  const double tolerance = 0.115;
  Subject subject(mesh, tolerance);
  const std::vector<Leaf> leaves = subject.leaves();
  SurfaceGroups trusting(leaves, 0, subject.oracle, 0);
  std::size_t on_trust = leaves.size();
  for (const MergeCost::Kind kind : kKinds)
    on_trust = std::min(on_trust, merged(trusting.leaves(), trusting, {kind, 0, 0}, Proof::kLater).size());
  SurfaceGroups groups(leaves, 0, subject.oracle, 0);
  const Cover cover = mergedBest(groups.leaves(), groups);
  EXPECT_GT(cover.size(), on_trust);
  EXPECT_LT(cover.size(), leaves.size());
  EXPECT_EQ(elementsIn(cover), upTo(leaves.size()));
  EXPECT_TRUE(groups.proven(cover));
  EXPECT_LE(subject.protrusionOf(exactHulls(cover, groups)), tolerance);
}

TEST(Merging, IsDeterministic) {
  const TriangleMesh mesh = torus(1, 0.3, 16, 8);
  std::vector<std::vector<int>> first;
  for (int run = 0; run < 2; ++run) {
    Subject subject(mesh, 0.1);
    SurfaceGroups groups(subject.leaves(), 60, subject.oracle, 0);
    const auto sets = elementSets(merged(groups.leaves(), groups, {MergeCost::kGrowth, 0.3, 5}, Proof::kLater));
    if (run == 0) first = sets;
    EXPECT_EQ(sets, first);
  }
}

TEST(Merging, AfterADeadlineTheCoverIsAsItWas) {
  Subject subject(box(1, 2, 3, 3), 0.05);
  SurfaceGroups groups({leafOf(subject.mesh.mesh)}, 64, subject.oracle, 0);
  subject.control.deadline = std::chrono::steady_clock::now();
  subject.control.stops_at_deadline = true;
  const Cover cover = mergedBest(singlesOf(groups, 64), groups);
  EXPECT_EQ(cover.size(), 64u);
  EXPECT_EQ(elementsIn(cover), upTo(64));
}

}  // namespace
}  // namespace collision_hulls
