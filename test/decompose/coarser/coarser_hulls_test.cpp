#include "decompose/coarser/coarser_hulls.h"

#include <gtest/gtest.h>

#include <random>

#include "shapes.h"

namespace collision_hulls {
namespace {

using Vector = Eigen::Vector3d;

/// A box between two corners.
ConvexHull box(const Vector& low, const Vector& high) {
  std::vector<Vector> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return convexHull(corners);
}

ConvexHull around(const std::vector<ConvexHull>& hulls) {
  std::vector<Vector> points;
  for (const ConvexHull& hull : hulls) points.insert(points.end(), hull.vertices.begin(), hull.vertices.end());
  return convexHull(points);
}

std::vector<const ConvexHull*> pointersTo(const std::vector<ConvexHull>& hulls) {
  std::vector<const ConvexHull*> pointers;
  for (const ConvexHull& hull : hulls) pointers.push_back(&hull);
  return pointers;
}

double nearest(const std::vector<ConvexHull>& hulls, const Vector& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexHull& hull : hulls) least = std::min(least, distance(hull, p));
  return least;
}

/// A point of a hull: any convex combination of its vertices.
Vector pointOf(const ConvexHull& hull, std::mt19937& random) {
  std::exponential_distribution<double> share;
  Vector sum = Vector::Zero();
  double total = 0;
  for (const Vector& vertex : hull.vertices) {
    const double s = std::pow(share(random), 3);  // near few vertices
    sum += s * vertex;
    total += s;
  }
  return sum / total;
}

std::vector<ConvexHull> scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 1), size(0.05, 0.3);
  std::vector<ConvexHull> hulls;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector low(place(random), place(random), place(random));
    hulls.push_back(box(low, low + Vector(size(random), size(random), size(random))));
  }
  return hulls;
}

TEST(FurthestFrom, HalfwayAcrossAGap) {
  const std::vector<ConvexHull> cubes{box({0, 0, 0}, {1, 1, 1}), box({3, 0, 0}, {4, 1, 1})};
  const double bound = furthestFrom(pointersTo(cubes), around(cubes));
  EXPECT_GE(bound, 1);
  EXPECT_LE(bound, 1.031);
}

TEST(FurthestFrom, NothingIsAddedWhereThePartsFillTheirHull) {
  const std::vector<ConvexHull> halves{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};
  EXPECT_LT(furthestFrom(pointersTo(halves), around(halves)), 0.2) << "no cell lies in one half, but they shrink";
  const std::vector<ConvexHull> nested{box({0, 0, 0}, {2, 2, 2}), box({0.5, 0.5, 0.5}, {1, 1, 1})};
  EXPECT_LT(furthestFrom(pointersTo(nested), around(nested)), 1e-9);
}

/// The inside of the corner of two thin plates: the point of the hull nearest to neither is on the bisector, at a / (2 + sqrt(2)).
TEST(FurthestFrom, TheCornerOfTwoPlates) {
  const double thin = 1e-4;
  const std::vector<ConvexHull> plates{box({0, 0, 0}, {1, 0.2, thin}), box({0, 0, 0}, {thin, 0.2, 1})};
  const double exact = 0.5;  // the middle of the slanted face, from both
  const double bound = furthestFrom(pointersTo(plates), around(plates));
  EXPECT_GE(bound, exact - thin);
  EXPECT_LE(bound, 1.04 * exact);
}

TEST(FurthestFrom, NoPointIsFurther) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<ConvexHull> hulls = scattered(2 + seed % 4, seed);
    const ConvexHull hull = around(hulls);
    const double bound = furthestFrom(pointersTo(hulls), hull);
    std::mt19937 random(seed);
    double found = 0;
    for (int i = 0; i < 20000; ++i) found = std::max(found, nearest(hulls, pointOf(hull, random)));
    EXPECT_GE(bound, found);
    EXPECT_LE(bound, 1.5 * found) << "of use";
  }
}

TEST(CoarserHulls, OneHullIsATree) {
  const HullTree tree = coarserHulls({box({0, 0, 0}, {1, 1, 1})}, 0.01);
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.nodes[0].protrusion, 0.01);
  EXPECT_TRUE(coarserHulls({}, 0).nodes.empty());
}

TEST(CoarserHulls, ATreeOfCutsOverTheHulls) {
  for (const std::size_t count : {2u, 5u, 20u}) {
    SCOPED_TRACE(count);
    const std::vector<ConvexHull> hulls = scattered(count, 7);
    const HullTree tree = coarserHulls(hulls, 0.02);
    ASSERT_EQ(tree.nodes.size(), 2 * count - 1);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(tree.nodes[i].hull.vertices, hulls[i].vertices) << "leaves in their order";
    EXPECT_EQ(tree.cutTo(1), std::vector<int>{static_cast<int>(tree.nodes.size()) - 1});
    for (const HullNode& node : tree.nodes) {
      if (node.left < 0) continue;
      for (const int child : {node.left, node.right}) {
        const HullNode& part = tree.nodes[static_cast<std::size_t>(child)];
        EXPECT_LE(part.protrusion, node.protrusion);
        for (const Vector& vertex : part.hull.vertices) EXPECT_LT(planeDistance(node.hull, vertex), 1e-9);
      }
    }
    for (const double tolerance : {0.02, 0.05, 0.2, 2.0}) EXPECT_TRUE(tree.isCut(tree.cutAt(tolerance)));
    EXPECT_EQ(tree.cutAt(2).size(), 1u);
  }
}

/// Each node's bound, against points of its hull: also where it stands on its children's bounds, above six leaves.
TEST(CoarserHulls, BoundsHold) {
  const double bound = 0.02;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<ConvexHull> hulls = scattered(12, seed);
    std::mt19937 random(seed);
    for (const HullNode& node : coarserHulls(hulls, bound).nodes) {
      for (int i = 0; i < 1000; ++i) EXPECT_LE(nearest(hulls, pointOf(node.hull, random)) + bound, node.protrusion + 1e-9);
    }
  }
}

TEST(CoarserHulls, MergesWhatAddsLeastFirst) {
  const HullTree tree = coarserHulls({box({0, 0, 0}, {1, 1, 1}), box({9, 0, 0}, {10, 1, 1}), box({1.1, 0, 0}, {2, 1, 1})}, 0);
  ASSERT_EQ(tree.nodes.size(), 5u);
  EXPECT_EQ(tree.nodes[3].left, 0);
  EXPECT_EQ(tree.nodes[3].right, 2);
}

TEST(CoarserHulls, Cancelled) {
  RunControl control;
  control.cancel();
  EXPECT_ANY_THROW(coarserHulls(scattered(3, 1), 0, control));
}

}  // namespace
}  // namespace collision_hulls
