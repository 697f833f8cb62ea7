#include "decompose/certified/local_search.h"

#include <gtest/gtest.h>

#include "decompose/certified/merging.h"
#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

const auto kSilent = [](double) {};

TEST(LocalSearch, WithoutEvaluationsKeepsTheCover) {
  Subject subject(uChannel(), 0.05);
  SurfaceGroups groups(subject.leaves(), 12, subject.oracle, 0);
  const Cover cover = groups.leaves();
  EXPECT_EQ(elementSets(improved(cover, groups, {0, 1}, kSilent)), elementSets(cover));
}

TEST(LocalSearch, MergesSingleElements) {
  const TriangleMesh mesh = uChannel(1, 1, 0.1, 2, 2);
  Subject subject(mesh, 0.05);
  const std::vector<Leaf> leaves = subject.leaves();
  SurfaceGroups groups(leaves, 24, subject.oracle, 0);
  const Cover cover = improved(singlesOf(groups, 24), groups, {3000, 1}, kSilent);
  EXPECT_LT(cover.size(), 24u);
  EXPECT_GE(cover.size(), 3u);
  EXPECT_EQ(elementsIn(cover), upTo(24));
}

TEST(LocalSearch, ReturnsAProvenCoverWithNoMoreGroups) {
  constexpr std::size_t kElements = 60;
  const TriangleMesh mesh = torus(1, 0.3, 16, 8);
  for (std::uint64_t seed : {1, 2, 3}) {
    Subject subject(mesh, 0.1);
    SurfaceGroups groups(subject.leaves(), kElements, subject.oracle, 0);
    const Cover before = mergedBest(groups.leaves(), groups);
    double share = 0;
    const Cover after = improved(before, groups, {300, seed}, [&](double done) {
      EXPECT_TRUE(done >= share && done <= 1);
      share = done;
    });
    EXPECT_LE(after.size(), before.size());
    EXPECT_EQ(elementsIn(after), upTo(kElements));
    EXPECT_TRUE(groups.proven(after));
    const std::vector<ConvexHull> hulls = exactHulls(after, groups);
    EXPECT_LE(uncovered(subject.mesh.mesh, hulls), 1e-12 * diagonal(mesh));
    EXPECT_LE(subject.protrusionOf(hulls), 0.1);
  }
}

TEST(LocalSearch, IsDeterministic) {
  std::vector<std::vector<int>> first;
  for (int run = 0; run < 2; ++run) {
    Subject subject(torus(1, 0.3, 16, 8), 0.1);
    SurfaceGroups groups(subject.leaves(), 60, subject.oracle, 0);
    const auto sets = elementSets(improved(groups.leaves(), groups, {200, 7}, kSilent));
    if (run == 0) first = sets;
    EXPECT_EQ(sets, first);
  }
}

TEST(LocalSearch, CanBeCancelled) {
  Subject subject(torus(1, 0.3, 16, 8), 0.1);
  SurfaceGroups groups(subject.leaves(), 60, subject.oracle, 0);
  const Cover cover = groups.leaves();
  subject.control.cancel();
  EXPECT_THROW(improved(cover, groups, {200, 7}, kSilent), Error);
}

}  // namespace
}  // namespace collision_hulls
