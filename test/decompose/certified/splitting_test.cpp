// Also tests src/decompose/certified/plane_score.cpp and src/decompose/certified/split_planes.cpp.
#include "decompose/certified/splitting.h"

#include <gtest/gtest.h>

#include "decompose/certified/largest_side.h"
#include "mesh/loose_segments.h"
#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

double areaOf(const std::vector<Leaf>& leaves) {
  double sum = 0;
  for (const Leaf& leaf : leaves) sum += area(leaf.block.surface);
  return sum;
}

std::vector<ConvexHull> hullsOf(const std::vector<Leaf>& leaves) {
  std::vector<ConvexHull> hulls;
  for (const Leaf& leaf : leaves) hulls.push_back(leaf.hull);
  return hulls;
}

/// The leaves make up the surface, cover it, and fit the tolerance.
std::vector<Leaf> checkedLeaves(const TriangleMesh& mesh, double share, const SplitOptions& options = {}) {
  Subject subject(mesh, share * diagonal(mesh));
  double done = 0;
  const std::vector<Leaf> leaves = splitIntoLeaves(subject.mesh, subject.oracle, options, [&](double part) {
    EXPECT_GE(part, done);
    done = part;
  });
  EXPECT_NEAR(done, 1, 1e-9);
  EXPECT_NEAR(areaOf(leaves), area(subject.mesh.mesh), 1e-9 * area(mesh));
  EXPECT_LE(uncovered(subject.mesh.mesh, hullsOf(leaves)), 1e-12 * diagonal(mesh));
  EXPECT_LE(subject.protrusionOf(hullsOf(leaves)), subject.oracle.tolerance());
  for (const Leaf& leaf : leaves)
    for (const Eigen::Vector3d& v : leaf.block.surface.vertices) EXPECT_LE(planeDistance(leaf.hull, v), 1e-12 * diagonal(mesh));
  return leaves;
}

TEST(Splitting, ConvexInputIsOneLeaf) {
  EXPECT_EQ(checkedLeaves(box(1, 2, 3), 0.01).size(), 1u);
  EXPECT_EQ(checkedLeaves(singleTriangle(), 0.01).size(), 1u);
  EXPECT_EQ(checkedLeaves(sheet(), 0.01).size(), 1u);
}

TEST(Splitting, LoosePointsAreLeaves) {
  RepairedMesh mesh;
  mesh.loose = test_shapes::loosePoints({{0, 0, 0}, {5, 0, 0}, {0, 7, 0}});
  const RunControl control;
  const Solid solid(mesh);
  ProtrusionOracle oracle(solid, boundingBox(mesh), 0.1, control);
  const std::vector<Leaf> leaves = splitIntoLeaves(mesh, oracle, {}, [](double) {});
  ASSERT_EQ(leaves.size(), 3u);
  for (const Segment& point : mesh.loose) {
    const std::vector<Eigen::Vector3d> own{point[0]};
    EXPECT_TRUE(std::any_of(leaves.begin(), leaves.end(), [&](const Leaf& leaf) { return leaf.block.surface.vertices == own; }));
  }
}

TEST(Splitting, ASegmentIsDivided) {
  const SurfacePiece segment{{{0, 0, 0}, {3, 0, 0}}, {{0, 1, 1}}};
  const auto [beneath, above] = split(segment, {Eigen::Vector3d::UnitX(), 1}, 1e-9);
  ASSERT_EQ(beneath.triangles.size(), 1u);
  ASSERT_EQ(above.triangles.size(), 1u);
  EXPECT_NEAR(boundingBox(beneath).max().x(), 1, 1e-12);
  EXPECT_NEAR(boundingBox(above).min().x(), 1, 1e-12);
  EXPECT_NEAR(boundingBox(above).max().x(), 3, 1e-12);
}

TEST(Splitting, WallsAreLeaves) {
  EXPECT_EQ(checkedLeaves(lBracket(), 0.02).size(), 2u);
  EXPECT_EQ(checkedLeaves(lBracket(1, 0.1, 1, 3), 0.02).size(), 2u);
  EXPECT_GE(checkedLeaves(uChannel(), 0.02).size(), 3u);
}

TEST(Splitting, DisconnectedPartsAreLeaves) {
  EXPECT_EQ(checkedLeaves(fourSpheres(), 0.02).size(), 4u);
}

TEST(Splitting, RoundShapesGiveFittingLeaves) {
  for (const ScoreWeights& weights : {ScoreWeights{}, ScoreWeights{0.5, 0.3, 0}, ScoreWeights{0.1, 0, 0.1}}) {
    SplitOptions options;
    options.weights = weights;
    EXPECT_GT(checkedLeaves(torus(1, 0.3, 16, 8), 0.03, options).size(), 4u);
  }
}

TEST(Splitting, LargestSideFirstGivesFittingLeavesToo) {
  const auto leaves = [](const TriangleMesh& mesh, double share) {
    Subject subject(mesh, share * diagonal(mesh));
    SplitOptions options;
    options.largest_side = largestSide(withLoose(subject.mesh), subject.oracle);
    EXPECT_TRUE(options.largest_side);
    return checkedLeaves(mesh, share, options).size();
  };
  EXPECT_EQ(leaves(lBracket(), 0.02), 2u);
  EXPECT_GE(leaves(uChannel(), 0.02), 3u);
  EXPECT_GT(leaves(torus(1, 0.3, 16, 8), 0.03), 4u);
}

TEST(Splitting, StopsAtTheLimitOnLeaves) {
  Subject subject(torus(1, 0.3, 32, 16), 0.01);
  SplitOptions options;
  const std::size_t all = subject.leaves().size();
  options.most_leaves = all / 4;
  const std::vector<Leaf> leaves = subject.leaves(options);
  EXPECT_GE(leaves.size(), options.most_leaves);
  EXPECT_LT(leaves.size(), all);
  const auto is_surplus = [](const Leaf& leaf) { return leaf.is_surplus; };
  EXPECT_TRUE(std::any_of(leaves.begin(), leaves.end(), is_surplus));
  for (const Leaf& leaf : leaves) EXPECT_FALSE(leaf.is_surplus && leaf.fits);
  const std::vector<Leaf> unlimited = subject.leaves();
  EXPECT_TRUE(std::none_of(unlimited.begin(), unlimited.end(), is_surplus));
  EXPECT_LE(uncovered(subject.mesh.mesh, hullsOf(leaves)), 1e-12);
}

/// For large pieces the hull of a selection of points is tried first: this must also work if one of the others alone makes the piece unfit.
TEST(Splitting, IgnoresNoPointOfALargePiece) {
  const TriangleMesh ball = sphere(1, 20);
  ASSERT_GE(ball.vertices.size(), 4000u);
  for (const double spike : {1.0, 1.5}) {
    TriangleMesh mesh = ball;
    mesh.vertices[3] *= spike;  // not in the selection tried first
    Subject subject(mesh, 0.05 * diagonal(mesh));
    const std::vector<Leaf> leaves = splitIntoLeaves(subject.mesh, subject.oracle, {}, [](double) {});
    EXPECT_EQ(leaves.size() > 1, spike > 1);
    for (const Leaf& leaf : leaves) {
      EXPECT_TRUE(subject.oracle.fits(leaf.hull));
      double beyond = 0;
      for (const Eigen::Vector3d& v : leaf.block.surface.vertices) beyond = std::max(beyond, planeDistance(leaf.hull, v));
      EXPECT_LE(beyond, 1e-10 * diagonal(mesh));
    }
  }
}

TEST(Splitting, KeepsTheVertexCapWithinTheTolerance) {
  const TriangleMesh ball = sphere(1, 4);
  EXPECT_EQ(checkedLeaves(ball, 0.01).size(), 1u);
  SplitOptions options;
  options.max_vertices = 12;
  EXPECT_GT(checkedLeaves(ball, 0.01, options).size(), 1u);
}

TEST(Splitting, IsDeterministic) {
  const TriangleMesh mesh = torus(1, 0.3, 16, 8);
  const std::vector<Leaf> a = checkedLeaves(mesh, 0.05), b = checkedLeaves(mesh, 0.05);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].hull.vertices, b[i].hull.vertices);
}

TEST(Splitting, CanBeCancelled) {
  Subject subject(torus(1, 0.3, 16, 8), 0.1);
  const auto cancel = [&](double) { subject.control.cancel(); };
  EXPECT_THROW(splitIntoLeaves(subject.mesh, subject.oracle, {}, cancel), Error);
}

// An L has its inner corner at x = y = 0.1; the plane through it that bisects the angle separates the walls.
const HalfSpace kAtTheCorner{Eigen::Vector3d(1, -1, 0).normalized(), 0}, kThroughAWall{Eigen::Vector3d::UnitX(), 0.7},
    kAside{Eigen::Vector3d::UnitX(), 2};

class PlaneScoreOfABracket : public ::testing::Test {
 protected:
  Subject subject{lBracket(), 0.03};
  ConvexHull hull = hullOf(subject.mesh.mesh);
  PlaneScore score{subject.mesh.mesh, 200, subject.oracle.intruders(hull, 100), volume(hull), {}, subject.control};
};

TEST_F(PlaneScoreOfABracket, PrefersTheCutAtTheCorner) {
  const std::vector<HalfSpace> best = score.best({kThroughAWall, kAside, kAtTheCorner}, 3);
  ASSERT_EQ(best.size(), 2u) << "planes that divide nothing are left out";
  EXPECT_EQ(best[0].offset, kAtTheCorner.offset);
  EXPECT_EQ(best[1].offset, kThroughAWall.offset);
  EXPECT_EQ(score.best({kThroughAWall, kAtTheCorner}, 1).size(), 1u);
  EXPECT_TRUE(score.best({}, 3).empty());
}

TEST_F(PlaneScoreOfABracket, KeepsTheOrderOfEqualPlanes) {
  const HalfSpace turned{-kThroughAWall.normal, -kThroughAWall.offset};
  EXPECT_EQ(score.best({turned, kThroughAWall}, 1)[0].offset, turned.offset);
  EXPECT_EQ(score.best({kThroughAWall, turned}, 1)[0].offset, kThroughAWall.offset);
}

}  // namespace
}  // namespace collision_hulls
