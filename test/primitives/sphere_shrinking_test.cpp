#include "primitives/sphere_shrinking.h"

#include <gtest/gtest.h>

#include "primitives/sphere_choice.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

std::vector<Sphere> shrunkOf(const std::vector<Sphere>& spheres, const TriangleMesh& mesh, double tolerance) {
  const Solid solid = solidOf(mesh);
  return shrunk(spheres, mesh, TolerableSpace(solid, boundingBox(mesh), tolerance, {}), {});
}

TEST(ShrunkSpheres, OneBecomesTheSmallestAroundItsMesh) {
  const std::vector<Sphere> result = shrunkOf({{{0.4, 0.5, 0.5}, 1}}, box(1, 1, 1), 0.7);
  ASSERT_EQ(result.size(), 1U);
  EXPECT_NEAR(result[0].radius, std::sqrt(0.75), 0.02);
  EXPECT_LT((result[0].centre - Eigen::Vector3d(0.5, 0.5, 0.5)).norm(), 0.02);
  EXPECT_TRUE(covers(result, box(1, 1, 1)));
}

/// Else the proof that they cover would divide the surface without end.
TEST(ShrunkSpheres, HoldTheSurfaceByADepth) {
  const std::vector<Sphere> result = shrunkOf({{{0.4, 0.5, 0.5}, 1}}, box(1, 1, 1), 0.7);
  ASSERT_EQ(result.size(), 1U);
  for (const Eigen::Vector3d& corner : box(1, 1, 1).vertices) EXPECT_GT(result[0].radius, (corner - result[0].centre).norm() + 0.005 * 0.7);
}

TEST(ShrunkSpheres, WhatHoldsNothingOfItsOwnGoes) {
  const std::vector<Sphere> result = shrunkOf({{{0.5, 0.5, 0.5}, 0.2}, {{0.5, 0.5, 0.5}, 0.9}}, box(1, 1, 1), 0.5);
  ASSERT_EQ(result.size(), 1U);
  EXPECT_GT(result[0].radius, 0.8);
}

TEST(ShrunkSpheres, OverlapIsGivenUpWhereEitherHoldsIt) {
  const TriangleMesh bar = box(2, 1, 1);
  const std::vector<Sphere> result = shrunkOf({{{0.5, 0.5, 0.5}, 1}, {{1.5, 0.5, 0.5}, 1}}, bar, 0.6);
  ASSERT_EQ(result.size(), 2U);
  for (const Sphere& sphere : result) {
    EXPECT_GT(sphere.radius, std::sqrt(0.75) - 0.02);
    EXPECT_LT(sphere.radius, std::sqrt(0.75) + 0.06);
  }
  EXPECT_TRUE(covers(result, bar));
}

TEST(ShrunkSpheres, CoverWhatWasCoveredAndProtrudeLess) {
  for (const TriangleMesh& mesh : {lBracket(), uChannel(), flange(), torus(), sheet(), boxWithWindow()}) {
    const Solid solid = solidOf(mesh);
    const TolerableSpace space(solid, boundingBox(mesh), 0.05 * diagonal(mesh), {});
    const std::vector<Sphere> before = fewSpheres(mesh, space, {10000, 0}, {}).value();
    const std::vector<Sphere> after = shrunk(before, mesh, space, {});
    EXPECT_TRUE(covers(after, mesh));
    EXPECT_LE(after.size(), before.size());
    double sum_before = 0, sum_after = 0;
    for (const Sphere& sphere : before) sum_before += space.bound(sphere);
    for (const Sphere& sphere : after) {
      EXPECT_LE(space.bound(sphere), space.tolerance() * (1 + 1e-9));
      sum_after += space.bound(sphere);
    }
    EXPECT_LT(sum_after, sum_before);
  }
}

}  // namespace
}  // namespace collision_hulls
