#include "decompose/padding.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "geometry/pi.h"
#include "solids.h"

namespace collision_hulls {
namespace {

ConvexHull cube() {
  return test_shapes::boxHull({1, 2, 3}, {2, 3, 4});
}

TEST(Padding, HoldsEveryPointWithinIt) {
  test_shapes::RandomPoints random(3);
  for (const int max_vertices : {0, 64, 16}) {
    for (int i = 0; i < 6; ++i) {
      std::vector<Eigen::Vector3d> points;
      for (int k = 0; k < 20; ++k) points.push_back(Eigen::Vector3d(5, 0, 0) + random.inCube(0.3));
      const ConvexHull hull = convexHull(points), larger = padded(hull, 0.1, max_vertices);
      EXPECT_FALSE(exceedsCap(larger, max_vertices));
      EXPECT_TRUE(holdsPadding(larger, hull, 0.1));
      for (int k = 0; k < 500; ++k) EXPECT_LE(planeDistance(larger, random.on(surface(hull)) + 0.1 * random.onSphere()), 1e-9);
      for (const Eigen::Vector3d& v : larger.vertices) EXPECT_EQ(v, v.cast<float>().cast<double>());
    }
  }
}

TEST(Padding, AddsLittleMore) {
  const auto reach = [](const ConvexHull& hull, int max_vertices) { return addedDistance(padded(hull, 0.1, max_vertices), hull) / 0.1; };
  EXPECT_LT(reach(cube(), 0), 1.03);
  EXPECT_LT(reach(test_shapes::hullOf(test_shapes::sphere(0.1, 4)), 0), 1.03);
  EXPECT_LT(reach(cube(), 64), 1.15);
  EXPECT_LT(reach(test_shapes::boxHull({0, 0, 0}, {1, 1, 1e-6}), 0), 1.03);
}

TEST(Padding, AddsLittleToRoundHullsOfAnySize) {
  for (const double size : {0.01, 0.1, 1.0}) {
    const ConvexHull ball = capped(test_shapes::hullOf(test_shapes::sphere(size, 4)), 64);
    std::vector<Eigen::Vector3d> rims;
    for (int k = 0; k < 32; ++k)
      for (const double z : {0.0, size}) rims.emplace_back(size / 5 * std::cos(k * kPi / 16), size / 5 * std::sin(k * kPi / 16), z);
    const ConvexHull rod = convexHull(rims);
    for (const double padding : {0.002, 0.02, 0.1}) {
      EXPECT_LT(addedDistance(padded(ball, padding, 64), ball), 1.1 * padding) << size;
      EXPECT_LT(addedDistance(padded(rod, padding, 64), rod), 1.45 * padding) << size << ": as at a right angle that stays sharp";
      EXPECT_LT(addedDistance(padded(test_shapes::boxHull({0, 0, 0}, {size, size, size}), padding, 64),
                              test_shapes::boxHull({0, 0, 0}, {size, size, size})),
                1.2 * padding)
          << size;
    }
  }
}

TEST(Padding, FlatAndMinuteHulls) {
  for (const ConvexHull& hull : {convexHull({{1, 1, 1}}), convexHull({{0, 0, 0}, {1, 0, 0}}), convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                                 test_shapes::boxHull({100, 0, 0}, {100.000001, 1e-6, 1e-6})})
    EXPECT_TRUE(holdsPadding(padded(hull, 0.02, 64), hull, 0.02));
}

TEST(Padding, IsNotedWhereItLacks) {
  const ConvexHull larger = padded(cube(), 0.1, 64);
  EXPECT_FALSE(holdsPadding(larger, cube(), 0.101));
  EXPECT_FALSE(holdsPadding(cube(), cube(), 1e-6));
  ConvexHull shaved = larger;
  shaved.faces[0].offset -= 0.01;
  EXPECT_FALSE(holdsPadding(shaved, cube(), 0.1));
}

DecomposeOptions with(double tolerance, double padding) {
  DecomposeOptions options;
  options.tolerance = tolerance;
  options.padding = padding;
  return options;
}

/// Points within the padding of the surface lie in a hull, and no hull reaches further than padding and tolerance.
void expectPadded(const TriangleMesh& mesh, const CertifiedHulls& result, double padding) {
  const Solid solid = test_shapes::solidOf(mesh);
  test_shapes::RandomPoints random(5);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d p = random.on(mesh) + padding * random.onSphere();
    EXPECT_TRUE(
        std::any_of(result.hulls.begin(), result.hulls.end(), [&](const ConvexHull& hull) { return planeDistance(hull, p) <= 1e-9; }));
  }
  for (const ConvexHull& hull : result.hulls) {
    EXPECT_LE(hull.vertices.size(), 64u);
    for (const Eigen::Vector3d& v : hull.vertices) EXPECT_LE(solid.distance(v), result.bound);
  }
}

TEST(Padding, OfAMeshIsProved) {
  for (const TriangleMesh& mesh :
       {test_shapes::uChannel(0.2, 0.2, 0.02, 0.4), test_shapes::torus(0.2, 0.05), test_shapes::sheet(0.3, 0.2, 3)}) {
    const CertifiedHulls result = certifiedHulls(mesh, with(0.02, 0.03));
    EXPECT_TRUE(result.within_tolerance) << result.reason;
    EXPECT_LE(result.bound, 0.05);
    EXPECT_GT(result.bound, 0.03) << "they do reach as far as the padding";
    expectPadded(mesh, result, 0.03);
  }
}

TEST(Padding, OtherMethodsPad) {
  const TriangleMesh mesh = test_shapes::uChannel(0.2, 0.2, 0.02, 0.4);
  for (const Method method : {Method::kAcd, Method::kBoundingBox}) {
    DecomposeOptions options = with(0.1, 0.03);
    options.method = method;
    expectPadded(mesh, certifiedHulls(mesh, options), 0.03);
  }
}

TEST(Padding, SaysWhenVerticesAreTooFew) {
  DecomposeOptions options = with(0.001, 0.1);
  options.max_vertices = 16;
  const CertifiedHulls result = certifiedHulls(test_shapes::box(0.1, 0.2, 0.3), options);
  EXPECT_FALSE(result.within_tolerance);
  EXPECT_NE(result.reason.find("and the padding of 100 mm: padded hulls of few vertices (max-vertices 16)"), std::string::npos)
      << result.reason;
}

TEST(Padding, IsALength) {
  for (const double padding : {-0.01, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_ANY_THROW(certifiedHulls(test_shapes::box(1, 1, 1), with(0.1, padding)));
}

}  // namespace
}  // namespace collision_hulls
