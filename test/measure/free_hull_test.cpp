// Hulls that the surface leaves free.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "box_with_slit.h"
#include "measure/protrusion.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;
using test_shapes::hullOf;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

// A search takes cells as small as the plate is thin, all over it, and does not come to its end.
TEST(Protrusion, AThinPlateTakesNoSearch) {
  const TriangleMesh plate = test_shapes::box(1, 1, 0.001, 2);
  const Solid solid = solidOf(plate);
  EXPECT_LE(protrusion({hullOf(plate)}, solid, 1e-5).bound, 1e-5);
  const double e = 5e-9;  // larger by that all around, as by rounding: what is near an edge may be further
  const std::vector<ConvexHull> around{boxHull({-e, -e, -e}, {1 + e, 1 + e, 0.001 + e})};
  const Protrusion p = protrusion(around, solid, {1e-5, 1e-3, 0}, {});
  EXPECT_GE(p.bound, std::sqrt(3) * e);
  EXPECT_LE(p.bound, 2e-5);
}

/// A pyramid on a regular polygon about the z axis, from z = 0 to its tip.
ConvexHull needle(int sides, double radius, double tip) {
  std::vector<Vector3d> points{{0, 0, tip}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * test_shapes::kPi * i / sides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return convexHull(points);
}

/// The same mesh with its tip cut off.
TriangleMesh stump(int sides, double radius, double tip, double cut) {
  test_shapes::MeshBuilder builder;
  const auto at = [&](int i, double z) {
    const double angle = 2 * test_shapes::kPi * (i % sides) / sides, r = radius * (tip - z) / tip;
    return Vector3d(r * std::cos(angle), r * std::sin(angle), z);
  };
  for (int i = 0; i < sides; ++i) {
    builder.quad(at(i, 0), at(i + 1, 0), at(i + 1, tip - cut), at(i, tip - cut));
    builder.triangle(at(i + 1, 0), at(i, 0), {0, 0, 0});
    builder.triangle(at(i, tip - cut), at(i + 1, tip - cut), {0, 0, tip - cut});
  }
  return builder.mesh();
}

// The cut reaches e deep into a needle, and the needle's middle r. Towards the tip both grow with the distance from it, so the tip is e / r
// of its way to the middle from the cut. With its triangles taken away, that is all that bounds the hull: else its surface does.
TEST(Protrusion, WhatTheSurfaceLeavesFreeIsWithinAShareOfTheWayToTheMiddle) {
  for (const double cut : {0.02, 0.1}) {
    const Solid solid = solidOf(stump(16, 1, 20, cut));
    ConvexHull hull = needle(16, 1, 20);
    ASSERT_FALSE(solid.hasOpenings());
    EXPECT_NEAR(solid.distance({0, 0, 20}), cut, 1e-9);
    hull.triangles.clear();
    for (std::size_t i = 0; i < hull.faces.size(); ++i) {  // whichever face is the last
      std::rotate(hull.faces.begin(), hull.faces.begin() + 1, hull.faces.end());
      const double bound = protrusion({hull}, solid, {4 * cut, 0, 0}, {}).bound;
      EXPECT_GE(bound, cut);
      EXPECT_LE(bound, 1.1 * cut);
    }
  }
}

/// The points p with n . p <= 1 - `depth` |n| for all n of `planes`: each vertex is the pole of a face of their hull.
std::vector<Vector3d> behind(const std::vector<Vector3d>& planes, double depth) {
  std::vector<Vector3d> poles, result;
  for (const Vector3d& n : planes) poles.push_back(n / (1 - depth * n.norm()));
  for (const HalfSpace& face : convexHull(poles).faces) result.push_back(face.normal / face.offset);
  return result;
}

// What is e deep in a hull is the solid. The hull's triangles are taken away, so that only its faces bound it.
TEST(Protrusion, WhatTheSurfaceLeavesFreeIsWithinTheLongestWayIntoIt) {
  RandomPoints random(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vector3d> planes;
    const Vector3d shape(random.number(0.2, 3), random.number(0.2, 3), random.number(0.2, 3));
    for (int k = 0; k < 12; ++k) planes.push_back(random.onSphere().cwiseProduct(shape));
    if (!holds(convexHull(planes), Vector3d::Zero())) continue;
    double largest = 0;
    for (const Vector3d& n : planes) largest = std::max(largest, n.norm());
    const double e = random.number(0, 0.9) / largest;  // the planes are further than that from the middle
    const ConvexHull inner = convexHull(behind(planes, e));
    ConvexHull hull = convexHull(behind(planes, 0));
    double furthest = 0;
    for (const Vector3d& v : hull.vertices) furthest = std::max(furthest, distance(inner, v));
    hull.triangles.clear();
    EXPECT_GE(protrusion({hull}, solidOf(surface(inner)), {1e3, 0, 0}, {}).bound, furthest * (1 - 1e-9));
  }
}

// A share of the way to the middle, which is far, would be 0.4 mm.
TEST(Protrusion, ALongBoardThatTheSurfaceLeavesFree) {
  const double e = 3e-6;
  const Solid solid = solidOf(test_shapes::box(2, 0.4, 0.018));
  ConvexHull hull = boxHull({-e, -e, -e}, {2 + e, 0.4 + e, 0.018 + e});
  hull.triangles.clear();
  const double bound = protrusion({hull}, solid, {4 * e, 0, 0}, {}).bound;
  EXPECT_GE(bound, std::sqrt(3) * e);
  EXPECT_LE(bound, 1.001 * std::sqrt(3) * e);
}

// The middle of a rod is outside a block, but so near to it that it seems to be inside; around both, sheets make a summit in the rod.
TEST(Protrusion, AMiddleWithinTheBlurIsNotTakenForInside) {
  constexpr double kSide = 0.3, kHigh = 2, kRod = 1e-3, kAway = 1e-11;
  const auto sheetAt = [](const Vector3d& middle, const Vector3d& u, const Vector3d& v) {
    test_shapes::MeshBuilder builder;
    builder.quad(middle - u - v, middle + u - v, middle + u + v, middle - u + v);
    return builder.mesh();
  };
  std::vector<TriangleMesh> parts{test_shapes::moved(test_shapes::box(0.01, 0.02, 0.02), {kAway, -0.01, -0.01})};
  for (const double side : {-1.0, 1.0}) {
    parts.push_back(sheetAt({side * kSide, 0, 0}, {0, 0.999 * kSide, 0}, {0, 0, 0.999 * kHigh}));
    parts.push_back(sheetAt({0, side * kSide, 0}, {0.999 * kSide, 0, 0}, {0, 0, 0.999 * kHigh}));
    parts.push_back(sheetAt({0, 0, side * kHigh}, {0.999 * kSide, 0, 0}, {0, 0.999 * kSide, 0}));
  }
  const Solid solid = solidOf(test_shapes::merged(parts));
  EXPECT_NEAR(solid.distance({0, 0, 1}), kSide, 1e-12);
  for (const double gap : {3.6e-3, 3.9e-3, 4e-3})
    EXPECT_GE(protrusion({boxHull({-kRod, -kRod, -1.8}, {kRod, kRod, 1.8})}, solid, gap).bound, kSide) << gap;
}

// A blade through a crack meets no surface, and its middle is inside; what stands out of it is not. As below, its triangles are taken away.
TEST(Protrusion, AHullThroughACrackIsNotLeftFree) {
  const Solid solid = solidOf(test_shapes::boxWithSlit(1e-5));
  ASSERT_FALSE(solid.hasOpenings());
  ASSERT_GT(solid.sideError(), 0);
  ASSERT_TRUE(solid.contains({0.5, 0, -0.15}));
  ConvexHull blade = boxHull({0.3, -2e-6, -0.6}, {0.7, 2e-6, 0.3});
  blade.triangles.clear();
  EXPECT_GE(protrusion({blade}, solid, {1e-6, 0, 0}, {}).bound, 1.9e-6) << "nearly half its width";
}

// A post through a window meets no surface, and its middle is inside; what stands out of the window is not. Its triangles are taken away so
// that only the search of its inside tells.
TEST(Protrusion, AHullThroughAnOpeningIsNotLeftFree) {
  ConvexHull post = boxHull({0.45, 0.45, 0.2}, {0.55, 0.55, 1.3});
  post.triangles.clear();
  EXPECT_GE(protrusion({post}, solidOf(test_shapes::boxWithWindow(0.2)), {0.001, 0, 0}, {}).bound, 0.04) << "nearly half its width";
}

}  // namespace
}  // namespace collision_hulls
