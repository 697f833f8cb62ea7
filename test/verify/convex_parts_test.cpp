// Which components of a mesh are convex bodies.
#include "verify/convex_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "counted_looks.h"
#include "mesh/loose_segments.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

/// Triangles without an area, from each point to itself moved.
TriangleMesh needles(const std::vector<Eigen::Vector3d>& from, const Eigen::Vector3d& by) {
  TriangleMesh mesh;
  for (const Eigen::Vector3d& p : from) addSegment(mesh, {p, p + by});
  return mesh;
}

TEST(ConvexParts, HullsAreToldFromTheRest) {
  const ConvexParts parts = convexParts(merged({box(1, 1, 1, 3), lBracket(), moved(box(1, 1, 1), {0.5, 0.5, 0.5}), test_shapes::sheet()}));
  EXPECT_EQ(parts.hulls.size(), 2u);
  EXPECT_EQ(parts.rest_parts, 2u);
  EXPECT_EQ(parts.rest.triangles.size(), lBracket().triangles.size() + test_shapes::sheet().triangles.size());
}

TEST(ConvexParts, LooksAtEachTriangleOfEachPass) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 60);
  const std::size_t pass = sheet.triangles.size() / kLargeItemsBetweenLooks;
  ASSERT_GT(pass, 20u);
  EXPECT_GE(looksOf([&](const RunControl& control) { convexParts(sheet, control); }), 3 * pass) << "runs, their triangles, its component's";
}

TEST(ConvexParts, AThinPlateAndASphereAreConvex) {
  EXPECT_EQ(convexParts(box(1, 1, 1e-4)).hulls.size(), 1u);
  EXPECT_EQ(convexParts(test_shapes::sphere(1, 6)).hulls.size(), 1u);
}

TEST(ConvexParts, ADentIsNotConvex) {
  TriangleMesh dented = box(1, 1, 1, 4);
  for (Eigen::Vector3d& v : dented.vertices)
    if (std::abs(v.z() - 1) < 1e-9 && std::abs(v.x() - 0.5) < 1e-9 && std::abs(v.y() - 0.5) < 1e-9) v.z() -= 1e-4;
  EXPECT_EQ(convexParts(dented).hulls.size(), 0u);
}

TEST(ConvexParts, InsideOutIsStillABody) {
  TriangleMesh cube = box(1, 1, 1);
  for (Triangle& t : cube.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(convexParts(cube).hulls.size(), 1u);
}

TEST(ConvexParts, ALooseTriangleInAHullIsNoRest) {
  const std::vector<Eigen::Vector3d> inside{{0.2, 0.2, 0.2}, {2.2, 0.5, 0.5}}, across{{0.8, 0.5, 0.5}}, beside{{5, 5, 5}};
  const Eigen::Vector3d by(0.5, 0, 0);
  const std::vector<TriangleMesh> cubes{box(1, 1, 1), moved(box(1, 1, 1), {2, 0, 0})};
  const auto rest = [&](const TriangleMesh& loose, bool first) {
    const ConvexParts parts = convexParts(first ? merged({loose, cubes[0], cubes[1]}) : merged({cubes[0], cubes[1], loose}));
    EXPECT_EQ(parts.hulls.size(), 2u);
    return parts.rest.triangles.size();
  };
  for (const bool first : {true, false}) {
    EXPECT_EQ(rest(needles(inside, by), first), 0u) << first;
    EXPECT_EQ(rest(needles(across, by), first), 1u) << first;
    EXPECT_EQ(rest(needles(beside, by), first), 1u) << first;
  }
  EXPECT_EQ(rest(needles({{0, 0, 0}, {2, 0, 0}}, {1, 1, 1}), false), 0u) << "from corner to corner";
}

// It is within single precision of each face's plane, but not of the hull.
TEST(ConvexParts, ALineBesideASharpEdgeIsRest) {
  const TriangleMesh wedge{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-4}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const Eigen::Vector3d at(0.5, 0.5, 0);
  EXPECT_EQ(convexParts(merged({wedge, needles({at}, {-0.01, -0.01, 0})})).rest.triangles.size(), 0u);
  EXPECT_EQ(convexParts(merged({wedge, needles({at}, {0.001, 0.001, 0})})).rest.triangles.size(), 1u);
  const ConvexParts near = convexParts(merged({wedge, needles({at}, {1e-7, 1e-7, 0})}));
  EXPECT_EQ(near.rest.triangles.size(), 0u);
  EXPECT_NEAR(near.beyond, std::sqrt(2) * 1e-7, 1e-12);
}

TEST(ConvexParts, ALooseTriangleIsComparedWithTheHullsNearIt) {
  constexpr int kCubes = 300;
  TriangleMesh row;
  std::vector<Eigen::Vector3d> inside;
  for (int i = 0; i < kCubes; ++i) {
    append(row, moved(box(1, 1, 1), {2.0 * i, 0, 0}));
    inside.emplace_back(2 * i + 0.2, 0.2, 0.2);
  }
  const TriangleMesh loose = needles(inside, {0.5, 0.1, 0.1});
  const auto looks = [](const TriangleMesh& mesh) { return looksOf([&](const RunControl& control) { convexParts(mesh, control); }); };
  const std::size_t apart = looks(row) + looks(loose), together = looks(merged({row, loose}));
  EXPECT_GE(together, apart + kCubes) << "each with the hull around it";
  EXPECT_LE(together, apart + 4 * kCubes) << "and with hardly any other";
}

/// Octahedra in one another, and triangles in the corners of their boxes, which none of them holds.
TEST(ConvexParts, ALooseTriangleInManyBoxesLooksAtEach) {
  constexpr std::size_t kHulls = 60;
  TriangleMesh mesh;
  for (std::size_t i = 0; i < kHulls; ++i) {
    const double size = 1 + 0.01 * static_cast<double>(i);
    std::vector<Eigen::Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis) corners.emplace_back(size * Eigen::Vector3d::Unit(axis)), corners.emplace_back(-corners.back());
    append(mesh, surface(convexHull(corners)));
  }
  std::vector<Eigen::Vector3d> outside;
  for (std::size_t i = 0; i < kHulls; ++i) outside.emplace_back(0.9, 0.9, 0.9 - 0.001 * static_cast<double>(i));
  append(mesh, needles(outside, {0.01, 0, 0}));
  const auto work = [&](const RunControl& control) { EXPECT_EQ(convexParts(mesh, control).rest.triangles.size(), kHulls); };
  const std::size_t looks = looksOf(work);
  EXPECT_GE(looks, kHulls * kHulls);
  EXPECT_EQ(looksAfterCancel(looks - kHulls, work), 1u);
}

}  // namespace
}  // namespace collision_hulls
