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

TEST(FlatSheets, ManyCoplanarTrianglesAreCertifiedClosely) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 80);
  ConvexHull plate = test_shapes::hullOf(sheet);
  for (Vector3d& v : plate.vertices) v += 1e-6 * (v - Vector3d(0.5, 0.5, 0));  // beyond the rim, like hulls as written
  const Protrusion p = protrusion({convexHull(plate.vertices)}, test_shapes::solidOf(sheet), 1e-5);
  EXPECT_LE(p.bound - p.found, 1e-5);
}

}  // namespace
}  // namespace collision_hulls
