#include "measure/flat_sheets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision_hulls/measure/measures.h"
#include "collision_hulls/measure/solid.h"
#include "random_points.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using Patch = std::array<Vector3d, 3>;

/// Two flat parts at a right angle, one with a window: triangles whose middle lies in the window are left out.
TriangleMesh bentSheetWithAWindow() {
  TriangleMesh flat = test_shapes::sheet(2, 1, 16), upright = test_shapes::sheet(1, 1, 8);
  for (Vector3d& v : upright.vertices) v = Vector3d(0, v.y(), v.x());
  TriangleMesh mesh = upright;
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), flat.vertices.begin(), flat.vertices.end());
  for (const Triangle& t : flat.triangles) {
    const Vector3d middle = (flat.vertices[static_cast<std::size_t>(t[0])] + flat.vertices[static_cast<std::size_t>(t[1])] +
                             flat.vertices[static_cast<std::size_t>(t[2])]) /
                            3;
    if (std::abs(middle.x() - 1.2) < 0.3 && std::abs(middle.y() - 0.5) < 0.2) continue;
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return mesh;
}

double largestDistance(const Patch& patch, const Solid& solid) {
  constexpr int kSteps = 12;
  double largest = 0;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
      largest = std::max(largest, solid.distanceToSurface(patch[0] + u * (patch[1] - patch[0]) + v * (patch[2] - patch[0])));
    }
  return largest;
}

TEST(FlatSheets, NoPointIsFurtherThanTheBound) {
  const Solid solid = test_shapes::solidOf(bentSheetWithAWindow());
  test_shapes::RandomPoints random(5);
  int bounded = 0;
  for (int i = 0; i < 4000; ++i) {
    const double size = std::pow(2.0, -(i % 8)), slack = 0.02 * (i % 3);
    const Vector3d centre = Vector3d(1, 0.5, 0.2) + random.inCube().cwiseProduct(Vector3d(1.1, 0.6, 0.3));
    const Patch patch{centre + size * random.inCube(), centre + size * random.inCube(), centre + size * random.inCube()};
    const TriangleBvh::Nearest near = solid.surface().nearest((patch[0] + patch[1] + patch[2]) / 3);
    const double bound = solid.heightAboveSheet(patch, near, slack);
    if (std::isinf(bound)) continue;
    ++bounded;
    ASSERT_LE(largestDistance(patch, solid), bound + 1e-12) << i;
  }
  EXPECT_GT(bounded, 300);
}

// Rounding may put an edge of such a patch on either side of the outline that it lies on.
TEST(FlatSheets, APatchBesideTheSheetIsNotAboveIt) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 2);
  test_shapes::RandomPoints random(7);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(random.inCube(), random.inCube());
    TriangleMesh turned = sheet;
    for (Vector3d& v : turned.vertices) v = turn * v;
    const Solid solid = test_shapes::solidOf(turned);
    for (int k = 0; k < 20; ++k) {
      const Vector3d at = random.inCube();
      const Patch patch{turn * Vector3d(1, 0.3 + 0.2 * at.x(), 0), turn * Vector3d(1, 0.7 + 0.2 * at.y(), 0),
                        turn * Vector3d(1.5 + 0.4 * at.z(), 0.5, 0)};
      const TriangleBvh::Nearest near = solid.surface().nearest((patch[0] + patch[1] + patch[2]) / 3);
      ASSERT_LE(largestDistance(patch, solid), solid.heightAboveSheet(patch, near, 0) + 1e-9) << i << ' ' << k;
    }
  }
}

TEST(FlatSheets, BoundsByHeightButOnlyAboveTheSheet) {
  const Solid solid = test_shapes::solidOf(test_shapes::sheet(1, 1, 10));
  const auto bound = [&](double x, double z, double slack) {
    const Patch patch{Vector3d(x, 0.2, z), Vector3d(x + 0.5, 0.3, z), Vector3d(x, 0.8, 2 * z)};
    return solid.heightAboveSheet(patch, solid.surface().nearest((patch[0] + patch[1] + patch[2]) / 3), slack);
  };
  EXPECT_NEAR(bound(0.2, 0.05, 0), 0.1, 1e-5);
  EXPECT_TRUE(std::isinf(bound(0.51, 0.05, 0))) << "a corner reaches beyond the sheet";
  EXPECT_NEAR(bound(0.51, 0.05, 0.05), 0.15, 1e-5) << "but by less than the slack";
  const Solid block = test_shapes::solidOf(test_shapes::box(1, 1, 1, 10));
  const Patch above{Vector3d(0.2, 0.2, 1.1), Vector3d(0.8, 0.2, 1.1), Vector3d(0.2, 0.8, 1.1)};
  EXPECT_TRUE(std::isinf(block.heightAboveSheet(above, block.surface().nearest(above[0]), 0))) << "solids have other bounds";
}

/// The bound of a patch over what is nearest to its middle.
double boundOf(const Patch& patch, const Solid& solid, double slack = 0) {
  return solid.heightAboveSheet(patch, solid.surface().nearest((patch[0] + patch[1] + patch[2]) / 3), slack);
}

// Patches in the plane of the sheet's first triangle: their height is 0, so all that they are away is the dent or the slack.

TEST(FlatSheets, ADentCountsWithItsDepth) {
  const double dent = 1e-6;  // of a diagonal of sqrt(2) as much is flat
  TriangleMesh sheet = test_shapes::sheet(1, 1, 10);
  int lowered = 0;
  for (Vector3d& v : sheet.vertices)
    if ((v - Vector3d(0.5, 0.5, 0)).norm() < 0.01) v.z() -= dent, ++lowered;
  ASSERT_EQ(lowered, 1);
  const Solid solid = test_shapes::solidOf(sheet);
  const Patch above{Vector3d(0.2, 0.2, 0), Vector3d(0.8, 0.3, 0), Vector3d(0.4, 0.9, 0)};
  EXPECT_NEAR(solid.distanceToSurface({0.5, 0.5, 0}), dent, 1e-9 * dent);
  EXPECT_GE(boundOf(above, solid), dent);
  EXPECT_LE(boundOf(above, solid), 1.001 * dent);
}

TEST(FlatSheets, WhatSticksOutByTheSlackIsThatFarAway) {
  const Solid solid = test_shapes::solidOf(test_shapes::sheet(1, 1, 10));
  const double slack = 0.1;
  for (const double out : {0.2, 0.5, 0.9, 0.99, 1.01, 1.05, 1.5}) {  // slacks
    const Patch patch{Vector3d(1 + out * slack, 0.5, 0), Vector3d(0.6, 0.45, 0), Vector3d(0.6, 0.55, 0)};
    const double bound = boundOf(patch, solid, slack);
    EXPECT_GE(bound, solid.distanceToSurface(patch[0])) << out;
    EXPECT_TRUE(out < 1 ? bound < 1.001 * slack : std::isinf(bound)) << out;
  }
}

TEST(FlatSheets, WhatLiesOverAHoleIsNotAboveTheSheet) {
  const Solid solid = test_shapes::solidOf(bentSheetWithAWindow());
  const Patch around{Vector3d(0.05, 0.02, 0.01), Vector3d(1.95, 0.02, 0.01), Vector3d(0.4, 0.98, 0.01)};  // around a corner of the window
  const Patch within{Vector3d(1.1, 0.45, 0.01), Vector3d(1.3, 0.45, 0.01), Vector3d(1.2, 0.55, 0.01)};
  const Patch beyond{Vector3d(1.1, 0.45, 0.01), Vector3d(1.3, 0.45, 0.01), Vector3d(1.2, 0.95, 0.01)};  // its middle above the hole, too
  const Patch beside{Vector3d(0.2, 0.1, 0.01), Vector3d(0.8, 0.1, 0.01), Vector3d(0.2, 0.9, 0.01)};
  for (const Patch& patch : {around, within, beyond}) EXPECT_TRUE(std::isinf(boundOf(patch, solid)));
  EXPECT_NEAR(boundOf(beside, solid), 0.01, 1e-5);
}

// A flap that is folded back onto a sheet is no part of its panel, or the fold would be no edge of that.
TEST(FlatSheets, APanelEndsWhereTheSheetIsFolded) {
  const TriangleMesh folded{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.1, 0}, {0.5, 0.9, 0}},
                            {{0, 1, 2}, {0, 2, 3}, {2, 1, 4}, {2, 4, 5}}};
  const Solid solid = test_shapes::solidOf(folded);
  const Patch over{Vector3d(0.7, 0.4, 0), Vector3d(1.2, 0.5, 0), Vector3d(0.7, 0.6, 0)};
  EXPECT_NEAR(solid.distanceToSurface(over[1]), 0.2, 1e-12);
  EXPECT_TRUE(std::isinf(boundOf(over, solid)));
  EXPECT_FALSE(std::isinf(boundOf({over[0], Vector3d(0.95, 0.5, 0), over[2]}, solid)));
}

TEST(FlatSheets, ManyCoplanarTrianglesAreCertifiedClosely) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 80);
  ConvexHull plate = test_shapes::hullOf(sheet);
  for (Vector3d& v : plate.vertices) v += 1e-6 * (v - Vector3d(0.5, 0.5, 0));  // beyond the rim, like hulls as written
  const Protrusion p = protrusion({convexHull(plate.vertices)}, test_shapes::solidOf(sheet), 1e-5);
  EXPECT_LE(p.bound - p.found, 1e-5);
}

}  // namespace
}  // namespace collision_hulls
