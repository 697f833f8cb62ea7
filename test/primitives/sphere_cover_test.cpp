#include "primitives/sphere_cover.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

constexpr CoverSearch kSearch{0.01, 0.1};

TEST(GapsIn, EveryGapIsInNoSphereThisDeep) {
  const TriangleMesh mesh = sheet(4, 4);
  const std::vector<Sphere> spheres{{{1, 1, 0}, 1.5}, {{3, 3, 0}, 1.5}};
  const std::vector<Eigen::Vector3d> gaps = gapsIn(mesh, spheres, kSearch, {});
  EXPECT_GT(gaps.size(), 100U);
  for (const Eigen::Vector3d& p : gaps)
    for (const Sphere& sphere : spheres) EXPECT_GT((p - sphere.centre).norm(), sphere.radius - kSearch.depth - 1e-9);
}

TEST(GapsIn, ATinyGapIsFound) {
  // Four discs that meet in the middle of a square, but for a gap of a thousandth.
  const TriangleMesh mesh = sheet(2, 2);
  const auto discs = [](double radius) {
    std::vector<Sphere> spheres;
    for (const double x : {0.5, 1.5})
      for (const double y : {0.5, 1.5}) spheres.push_back({{x, y, 0}, radius});
    return spheres;
  };
  EXPECT_TRUE(gapsIn(mesh, discs(std::sqrt(0.5) + 0.001), {1e-4, 0.1}, {}).empty());
  EXPECT_FALSE(gapsIn(mesh, discs(std::sqrt(0.5) - 0.001), {1e-4, 0.1}, {}).empty());
}

TEST(GapsIn, WithoutSpheresEverythingIsOne) {
  EXPECT_FALSE(gapsIn(box(1, 1, 1), {}, kSearch, {}).empty());
  EXPECT_TRUE(gapsIn(TriangleMesh{}, {}, kSearch, {}).empty());
}

}  // namespace
}  // namespace collision_hulls
