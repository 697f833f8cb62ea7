#include "mesh/boundary.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

using Boundary = std::vector<BoundaryEdge>;

/// Two unit squares that touch at vertex 2, and a vertex above.
const std::vector<Eigen::Vector3d> kVertices{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0.5, 0.5, 3}};
const Boundary kTwoSquares{{0, 0, 1}, {0, 1, 2}, {0, 2, 3}, {0, 3, 0}, {0, 2, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 2}};

TEST(Closures, NoBoundaryNeedsNoClosure) {
  const std::vector<Closure> closing = closures(kVertices, {}, 2, Eigen::Vector3d::Zero(), {});
  ASSERT_EQ(2u, closing.size());
  EXPECT_EQ(0, closing[1].area);
  EXPECT_EQ(0, closing[1].volume);
}

TEST(Closures, LoopsThatTouchAreClosedSeparately) {
  EXPECT_NEAR(2, closures(kVertices, kTwoSquares, 1, Eigen::Vector3d::Zero(), {})[0].area, 1e-12);
  const Boundary backwards(kTwoSquares.rbegin(), kTwoSquares.rend());
  EXPECT_NEAR(2, closures(kVertices, backwards, 1, Eigen::Vector3d::Zero(), {})[0].area, 1e-12);
}

TEST(Closures, SurfacesAreKeptApart) {
  Boundary boundary = kTwoSquares;
  for (std::size_t i = 4; i < 8; ++i) boundary[i].surface = 2;
  const std::vector<Closure> closing = closures(kVertices, boundary, 3, Eigen::Vector3d::Zero(), {});
  EXPECT_NEAR(1, closing[0].area, 1e-12);
  EXPECT_EQ(0, closing[1].area);
  EXPECT_NEAR(1, closing[2].area, 1e-12);
}

TEST(Closures, VolumeOfThePyramidToTheOrigin) {
  // The boundary runs counter-clockwise seen from above, so the fan faces down: the surface is a bowl seen from below.
  const Boundary square(kTwoSquares.begin(), kTwoSquares.begin() + 4);
  EXPECT_NEAR(1, closures(kVertices, square, 1, kVertices[7], {})[0].volume, 1e-12);
  EXPECT_NEAR(-1, closures(kVertices, square, 1, {0.5, 0.5, -3}, {})[0].volume, 1e-12);
}

TEST(Closures, OppositeEdgesCancel) {
  const Boundary seam{{0, 0, 1}, {0, 1, 0}, {0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(0, closures(kVertices, seam, 1, Eigen::Vector3d::Zero(), {})[0].area);
  Boundary square(kTwoSquares.begin(), kTwoSquares.begin() + 4);
  square.insert(square.end(), seam.begin(), seam.end());
  EXPECT_NEAR(1, closures(kVertices, square, 1, Eigen::Vector3d::Zero(), {})[0].area, 1e-12);
}

TEST(Closures, AChainThatDoesNotReturnIsClosedToo) {
  const Boundary chain(kTwoSquares.begin(), kTwoSquares.begin() + 3);
  EXPECT_NEAR(1, closures(kVertices, chain, 1, Eigen::Vector3d::Zero(), {})[0].area, 1e-12);
}

TEST(BoundaryLoops, AChainThatDoesNotReturnIsMarked) {
  const std::vector<BoundaryLoop> loops = boundaryLoops(6, {{0, 0, 1}, {0, 1, 2}, {1, 3, 4}, {1, 4, 5}, {1, 5, 3}}, {});
  ASSERT_EQ(2u, loops.size());
  EXPECT_FALSE(loops[0].returns);
  EXPECT_EQ((std::vector<int>{0, 1, 2}), loops[0].vertices);
  EXPECT_TRUE(loops[1].returns);
  EXPECT_EQ(1, loops[1].surface);
  EXPECT_EQ((std::vector<int>{3, 4, 5}), loops[1].vertices);
}

}  // namespace
}  // namespace collision_hulls
