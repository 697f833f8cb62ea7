#include "decompose/certified/surface_groups.h"

#include <gtest/gtest.h>

#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

constexpr double kTolerance = 0.03;

double areaOf(const std::vector<Element>& elements) {
  double sum = 0;
  for (const Element& e : elements) sum += e.area;
  return sum;
}

/// Two walls: two leaves, each divided into elements.
class GroupsOfABracket : public ::testing::Test {
 protected:
  static constexpr std::size_t kElements = 12;
  Group leaf(std::size_t i) { return groups.leaves().at(i); }

  Subject subject{lBracket(1, 0.1, 1, 2), kTolerance};
  std::vector<Leaf> leaves = subject.leaves();
  SurfaceGroups groups{leaves, kElements, subject.oracle, 0};
};

TEST(Elements, AreTheLeavesIfNoMoreAreWanted) {
  Subject subject(lBracket(), kTolerance);
  const std::vector<Leaf> leaves = subject.leaves();
  ASSERT_EQ(leaves.size(), 2u);
  for (std::size_t count : {0, 1, 2}) {
    const std::vector<Element> elements = elementsOf(leaves, count, kTolerance);
    ASSERT_EQ(elements.size(), 2u);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(elements[static_cast<std::size_t>(i)].leaf, i);
  }
}

TEST(Elements, APointIsNotHalved) {
  EXPECT_EQ(elementsOf({leafOf({{{1, 2, 3}}, {{0, 0, 0}}})}, 10, kTolerance).size(), 1u);
}

TEST(Elements, MakeUpTheSurfaceInsideTheirLeaves) {
  Subject subject(uChannel(1, 1, 0.1, 2, 2), kTolerance);
  const std::vector<Leaf> leaves = subject.leaves();
  const std::vector<Element> elements = elementsOf(leaves, 40, kTolerance);
  EXPECT_EQ(elements.size(), 40u);
  EXPECT_NEAR(areaOf(elements), area(subject.mesh.mesh), 1e-9);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    EXPECT_TRUE(i == 0 || elements[i - 1].leaf <= elements[i].leaf);
    const ConvexHull& hull = leaves[static_cast<std::size_t>(elements[i].leaf)].hull;
    for (const Eigen::Vector3d& p : elements[i].points) EXPECT_LE(planeDistance(hull, p), 1e-9);
  }
}

TEST(Elements, LikelyPointsAreFewAndCloseToTheRest) {
  const TriangleMesh ball = sphere(1, 30);  // 9,002 vertices
  const std::vector<Element> elements = elementsOf({leafOf(ball)}, 0, 0.1);
  ASSERT_EQ(elements.size(), 1u);
  EXPECT_EQ(elements[0].points.size(), 9002u);
  EXPECT_LT(elements[0].likely.size(), 300u);
  const ConvexHull likely = convexHull(elements[0].likely);
  for (const Eigen::Vector3d& p : elements[0].points) EXPECT_LE(planeDistance(likely, p), 0.3 * 0.1);
}

TEST_F(GroupsOfABracket, LeavesContainEveryElementOnce) {
  const Cover cover = groups.leaves();
  EXPECT_EQ(cover.size(), leaves.size());
  EXPECT_EQ(elementsIn(cover), upTo(kElements));
  EXPECT_TRUE(groups.proven(cover));
  EXPECT_EQ(groups.evaluations(), 0);
}

TEST_F(GroupsOfABracket, BothWallsDoNotFitOneHull) {
  EXPECT_FALSE(groups.merged(leaf(0), leaf(1)).hull);
  EXPECT_FALSE(groups.whole(upTo(kElements)).hull);
}

TEST_F(GroupsOfABracket, PartsOfOneWallFitOneHull) {
  const std::vector<int> wall = leaf(0).elements;
  ASSERT_GE(wall.size(), 3u);
  const Group two = groups.merged(groups.single(wall[0]), groups.single(wall[1]));
  ASSERT_TRUE(two.hull);
  EXPECT_EQ(two.elements, (std::vector<int>{wall[0], wall[1]}));
  EXPECT_NEAR(two.area, groups.single(wall[0]).area + groups.single(wall[1]).area, 1e-12);
  EXPECT_TRUE(groups.proven(two));
  const Group three = groups.merged(two, groups.single(wall[2]));
  EXPECT_TRUE(three.hull);
}

TEST_F(GroupsOfABracket, TheSameSetIsEvaluatedOnce) {
  const std::vector<int> wall = leaf(0).elements;
  const Group a = groups.single(wall[0]), b = groups.single(wall[1]);
  const Group merged = groups.merged(a, b);
  EXPECT_EQ(groups.evaluations(), 1);
  const Group again = groups.merged(b, a), whole = groups.whole({wall[0], wall[1]});
  EXPECT_EQ(groups.evaluations(), 1);
  EXPECT_EQ(again.key, merged.key);
  EXPECT_EQ(whole.key, merged.key);
  EXPECT_EQ(again.elements, merged.elements);
  EXPECT_EQ(whole.hull, merged.hull);
  EXPECT_NE(groups.merged(a, groups.single(wall[2])).key, merged.key);
  EXPECT_EQ(groups.evaluations(), 2);
}

TEST_F(GroupsOfABracket, ByLeafKeepsAllElements) {
  const std::vector<int> some{1, 2, static_cast<int>(kElements) - 2, static_cast<int>(kElements) - 1};
  const Cover parts = groups.byLeaf(some);
  EXPECT_EQ(parts.size(), 2u);
  EXPECT_EQ(elementsIn(parts), some);
  EXPECT_TRUE(groups.proven(parts));
}

TEST_F(GroupsOfABracket, AHullCoversItsOwnElementsAndTakesOverOthers) {
  Group wall = leaf(0);
  for (int e : wall.elements) EXPECT_TRUE(groups.covers(groups.single(e), e));
  const Group first = groups.single(wall.elements.front());
  EXPECT_FALSE(groups.covers(first, leaf(1).elements.back()));
  Group all = first;
  all.hull = std::make_shared<ConvexHull>(hullOf(subject.mesh.mesh));
  for (int e : upTo(kElements)) all.widths = all.widths.merged(groups.single(e).widths);
  for (int e : upTo(kElements))
    if (e != wall.elements.front()) {
      EXPECT_TRUE(groups.covers(all, e)) << e;
      groups.add(e, all);
    }
  EXPECT_EQ(all.elements, upTo(kElements));
  EXPECT_EQ(all.key, groups.whole(upTo(kElements)).key);
  EXPECT_NEAR(all.area, area(subject.mesh.mesh), 1e-9);
}

TEST_F(GroupsOfABracket, AProofRefutesWhatWasAcceptedProvisionally) {
  Group both = groups.single(0);
  for (int e : upTo(kElements))
    if (e != 0) groups.add(e, both);
  EXPECT_FALSE(groups.proven(both));
  EXPECT_FALSE(groups.proven(Cover{leaf(0), both}));
}

TEST_F(GroupsOfABracket, ProofsAreForgottenExceptThoseToKeep) {
  const std::vector<int> wall = leaf(0).elements, other = leaf(1).elements;
  const Group some = groups.whole({wall.begin(), wall.begin() + 2}), others = groups.whole({other.begin(), other.begin() + 2});
  ASSERT_TRUE(groups.proven(Cover{some, others}));
  groups.keepProofsOf({some});
  EXPECT_TRUE(groups.isProven(some));
  EXPECT_FALSE(groups.isProven(others));
  EXPECT_TRUE(groups.proven(others));
}

TEST_F(GroupsOfABracket, ExactHullsCoverWithinTheTolerance) {
  const std::vector<ConvexHull> hulls = exactHulls(groups.leaves(), groups);
  EXPECT_LE(uncovered(subject.mesh.mesh, hulls), 1e-12);
  EXPECT_LE(subject.protrusionOf(hulls), kTolerance);
}

}  // namespace
}  // namespace collision_hulls
