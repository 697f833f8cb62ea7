#include "primitives/surface_patch.h"

#include <gtest/gtest.h>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::box;
using test_shapes::moved;
using test_shapes::RandomPoints;

const ConvexHull kEverything = convexHull(box(20, 20, 20).vertices);  // from the origin on

SurfacePatch all(const TriangleMesh& mesh) {
  return SurfacePatch(mesh, kEverything);
}

Eigen::Vector3d sizesOf(const SurfacePatch& patch, double depth) {
  return boundingBox(patch.hull(depth)).sizes();
}

void expectNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  EXPECT_LT((a - b).norm(), 1e-5) << a.transpose() << " and " << b.transpose();  // hulls of what is flat have some thickness
}

/// The patches of 2^levels parts, but for empty ones.
std::vector<SurfacePatch> divided(const SurfacePatch& patch, int levels, double flatness) {
  std::vector<SurfacePatch> result{patch};
  for (int level = 0; level < levels; ++level) {
    std::vector<SurfacePatch> next;
    for (const SurfacePatch& each : result)
      for (SurfacePatch& part : each.parts(flatness, 0.01))
        if (!part.empty()) next.push_back(std::move(part));
    result = std::move(next);
  }
  return result;
}

TEST(SurfacePatch, TheHullReachesBelowTheSurface) {
  const SurfacePatch plate = all(moved(test_shapes::sheet(1, 2), {1, 1, 1}));
  expectNear(sizesOf(plate, 0), {1, 2, 0});
  const Eigen::AlignedBox3d deep = boundingBox(plate.hull(0.1));
  expectNear(deep.sizes(), {1, 2, 0.1});
  EXPECT_NEAR(deep.max().z(), 1, 1e-12) << "the sheet faces upward";
}

TEST(SurfacePatch, HoldsWhatLiesInAHull) {
  const TriangleMesh cube = moved(box(1, 1, 1), {1, 1, 1});
  const SurfacePatch corner(cube, convexHull(moved(box(0.5, 0.5, 3), {0.8, 0.8, 0.5}).vertices));
  expectNear(sizesOf(corner, 0), {0.3, 0.3, 1});
  EXPECT_TRUE(SurfacePatch(cube, convexHull(moved(box(0.5, 0.5, 0.5), {1.2, 1.2, 1.2}).vertices)).empty()) << "all inside";
  const SurfacePatch touched(cube, convexHull(moved(box(1, 1, 1), {2, 1, 1}).vertices));
  expectNear(sizesOf(touched, 0), {0, 1, 1});
}

TEST(SurfacePatch, ALargeFlatPartComesFirst) {
  const TriangleMesh block = moved(box(1, 2, 0.5), {1, 1, 1});
  const std::array<SurfacePatch, 2> parts = all(block).parts(0.01, 0.1);
  expectNear(sizesOf(parts[0], 0), {1, 2, 0});
  expectNear(sizesOf(parts[1], 0), {1, 2, 0.5});
}

TEST(SurfacePatch, WhatFacesTheOtherWayIsNoPartOfIt) {
  const std::array<SurfacePatch, 2> parts = all(moved(box(1, 2, 0.005), {1, 1, 1})).parts(0.01, 0.1);
  EXPECT_EQ(boundingBox(parts[0].hull(0)).sizes().z() < 1e-4, true);
  EXPECT_FALSE(parts[1].empty());
}

TEST(SurfacePatch, WhatIsFlatIsHalvedAcrossItsLongerSide) {
  for (const SurfacePatch& half : all(moved(test_shapes::sheet(1, 3), {1, 1, 1})).parts(0.01, 0.1))
    expectNear(sizesOf(half, 0), {1, 1.5, 0});
}

TEST(SurfacePatch, NothingOfTheSurfaceIsLost) {
  for (const TriangleMesh& mesh : {moved(test_shapes::torus(1, 0.3), {2, 2, 2}), moved(test_shapes::flange(), {2, 2, 2})}) {
    const std::vector<SurfacePatch> patches = divided(all(mesh), 6, 0.05);
    EXPECT_GT(patches.size(), 30u);
    std::vector<ConvexHull> hulls;
    for (const SurfacePatch& patch : patches) hulls.push_back(patch.hull(0));
    RandomPoints random(1);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d p = random.on(mesh);
      const auto is_near = [&](const ConvexHull& hull) { return planeDistance(hull, p) < 1e-12; };
      EXPECT_TRUE(std::any_of(hulls.begin(), hulls.end(), is_near)) << p.transpose();
    }
  }
}

TEST(SurfacePatch, ATriangleWithoutAreaCounts) {
  const SurfacePatch patch = all({{{1, 1, 1}, {2, 1, 1}, {3, 1, 1}}, {{0, 1, 2}}});
  ASSERT_FALSE(patch.empty());
  expectNear(sizesOf(patch, 0.5), {2, 0, 0});
  double length = 0;
  for (const SurfacePatch& part : patch.parts(0.01, 0.5)) length += part.empty() ? 0 : sizesOf(part, 0).x();
  EXPECT_GT(length, 2 - 1e-5);
}

TEST(SurfacePatch, DropsWhatAPrimitiveHolds) {
  SurfacePatch patch = all(moved(box(1, 1, 1), {1, 1, 1}));
  Primitive below{PrimitiveKind::kBox, {3, 3, 3}, Eigen::Isometry3d(Eigen::Translation3d(1.5, 1.5, 0))};
  patch.dropWithin(below);
  expectNear(sizesOf(patch, 0), {1, 1, 1});
  EXPECT_TRUE(SurfacePatch(patch).parts(0.01, 0.1)[0].empty() == false);
  SurfacePatch top = patch;
  for (const Eigen::Vector3d& side :
       {Eigen::Vector3d(0, 1.5, 1.5), Eigen::Vector3d(3, 1.5, 1.5), Eigen::Vector3d(1.5, 0, 1.5), Eigen::Vector3d(1.5, 3, 1.5)})
    top.dropWithin({PrimitiveKind::kBox, {2.1, 2.1, 2.1}, Eigen::Isometry3d(Eigen::Translation3d(side))});
  expectNear(sizesOf(top, 0), {1, 1, 0});
  top.dropWithin({PrimitiveKind::kBox, {2, 2, 2}, Eigen::Isometry3d(Eigen::Translation3d(1.5, 1.5, 1))});
  EXPECT_FALSE(top.empty()) << "it lies in the primitive's side: rounded, it may not";
  top.dropWithin({PrimitiveKind::kSphere, {1, 0, 0}, Eigen::Isometry3d(Eigen::Translation3d(1.5, 1.5, 2))});
  EXPECT_TRUE(top.empty());
}

}  // namespace
}  // namespace collision_hulls
