#include "collision_hulls/decompose/round_outward.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using test_shapes::boxHull;
using test_shapes::hullOf;
using test_shapes::RandomPoints;

double sizeOf(const TriangleMesh& mesh) {
  double size = 0;
  for (const Vector3d& v : mesh.vertices) size = std::max(size, v.cwiseAbs().maxCoeff());
  return size;
}

bool isSingle(double x) {
  const volatile float single = static_cast<float>(x);  // volatile: see roundedToSingle() in round_outward.cpp
  return single == x;
}

/// What round_outward.h promises, checked on hulls rebuilt from the vertices as written.
RoundedHulls checkedFit(const std::vector<ConvexHull>& hulls, const TriangleMesh& mesh, double margin = 0, int max_vertices = 0) {
  const RoundedHulls fitted = roundOutward(hulls, mesh, margin, max_vertices);
  EXPECT_EQ(uncovered(mesh, fitted.hulls), 0);
  std::vector<ConvexHull> written;
  for (const ConvexHull& hull : fitted.hulls) {
    EXPECT_TRUE(max_vertices == 0 || hull.vertices.size() <= static_cast<std::size_t>(max_vertices)) << hull.vertices.size();
    for (const Vector3d& v : hull.vertices) EXPECT_TRUE(isSingle(v.x()) && isSingle(v.y()) && isSingle(v.z())) << v.transpose();
    EXPECT_GT(volume(hull), 0);
    written.push_back(convexHull(hull.vertices));
    EXPECT_EQ(written.back().thickness, 0);
  }
  EXPECT_EQ(uncovered(mesh, written), 0);
  EXPECT_EQ(fitted.hulls.size(), hulls.size());
  for (std::size_t h = 0; h < hulls.size() && fitted.completed == 0; ++h)
    for (const Vector3d& v : hulls[h].vertices) EXPECT_LE(planeDistance(fitted.hulls[h], v), -margin);
  return fitted;
}

/// The furthest distance of the fitted hulls' vertices from the given hulls.
double growth(const RoundedHulls& fitted, const std::vector<ConvexHull>& hulls) {
  double most = 0;
  for (std::size_t h = 0; h < hulls.size(); ++h)
    for (const Vector3d& v : fitted.hulls[h].vertices) most = std::max(most, distance(hulls[h], v));
  return most;
}

// Degenerate input.

TEST(RoundOutward, NothingToFit) {
  EXPECT_TRUE(roundOutward({}, {}, 0, 0).hulls.empty());
}

TEST(RoundOutward, TrianglesWithoutAnyHullAreAnInternalError) {
  try {
    roundOutward({}, test_shapes::box(1, 1, 1), 0, 0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInternal);
  }
}

TEST(RoundOutward, APointALineAndAPlane) {
  RandomPoints random(1);
  for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(1, 2, 3), Vector3d(1000, -1000, 1000)})
    for (int dimensions = 0; dimensions <= 2; ++dimensions) {
      SCOPED_TRACE(testing::Message() << dimensions << " dimensions at " << place.transpose());
      const Eigen::Matrix3d turn = random.rotation();
      TriangleMesh mesh;
      for (int i = 0; i < 12; ++i) {
        Vector3d p = random.inCube();
        p.tail(3 - dimensions).setZero();
        mesh.vertices.push_back(place + turn * p);
        if (i >= 2) mesh.triangles.push_back({i - 2, i - 1, i});
      }
      checkedFit({hullOf(mesh)}, mesh);
      checkedFit({hullOf(mesh)}, mesh, 0, 8);
    }
}

TEST(RoundOutward, UncoveredTrianglesAreAdded) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1, 2);
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{1.2, 0.5, 0.5}, {0.5, 0.5, 1.1}, {0.5, 0.5, 0.5}});
  mesh.triangles.push_back({first, first, first});
  mesh.triangles.push_back({first + 1, first + 2, first + 1});
  const RoundedHulls fitted = checkedFit({boxHull({0, 0, 0}, {1, 1, 1})}, mesh);
  EXPECT_EQ(fitted.completed, 2u);
}

TEST(RoundOutward, ATriangleGoesToTheHullThatGrowsLeast) {
  TriangleMesh mesh{{{1.1, 0.5, 0.5}, {1.1, 0.6, 0.5}, {1.1, 0.5, 0.6}}, {{0, 1, 2}}};
  const std::vector<ConvexHull> hulls{boxHull({3, 0, 0}, {4, 1, 1}), boxHull({0, 0, 0}, {1, 1, 1}), boxHull({-5, 0, 0}, {-4, 1, 1})};
  const RoundedHulls fitted = checkedFit(hulls, mesh);
  EXPECT_EQ(fitted.completed, 1u);
  EXPECT_LE(planeDistance(fitted.hulls[1], mesh.vertices[0]), 0);
  EXPECT_LT(volume(fitted.hulls[0]), 1.001);
  EXPECT_LT(volume(fitted.hulls[2]), 1.001);
}

TEST(RoundOutward, CoversATriangleAcrossASlit) {
  const TriangleMesh mesh{{{0.1, 0.1, 0.5}, {1.9, 0.1, 0.5}, {1, 0.9, 0.5}}, {{0, 1, 2}}};
  EXPECT_EQ(checkedFit({boxHull({0, 0, 0}, {0.99, 1, 1}), boxHull({1.01, 0, 0}, {2, 1, 1})}, mesh).completed, 1u);
}

// Closed-form answers.

TEST(RoundOutward, ABoxGrowsByTheMarginAndSinglePrecision) {
  const TriangleMesh mesh = test_shapes::box(1, 1, 1, 3);
  for (double margin : {0.0, 1e-6, 1e-3}) {
    const std::vector<ConvexHull> hulls{hullOf(mesh)};
    const RoundedHulls fitted = checkedFit(hulls, mesh, margin);
    EXPECT_GE(fitted.nudge, margin);
    EXPECT_LE(fitted.nudge, margin + 5e-7);
    EXPECT_LE(growth(fitted, hulls), 1.8 * fitted.nudge + 2e-7);
    EXPECT_EQ(fitted.completed, 0u);
    EXPECT_EQ(fitted.hulls[0].vertices.size(), 8u);
  }
}

/// A tip too sharp for a mitre becomes an octahedron, whose faces are as far out as the others: the first distance is enough.
TEST(RoundOutward, ASharpTipGrowsNoFurtherThanTheRest) {
  constexpr double kMargin = 1e-3;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    const Eigen::Matrix3d turn = RandomPoints(seed).rotation();
    std::vector<Vector3d> points{turn * Vector3d(1, 0, 0)};
    for (const double y : {-0.01, 0.01})
      for (const double z : {-0.01, 0.01}) points.push_back(turn * Vector3d(0, y, z));
    const ConvexHull spike = convexHull(points);
    const RoundedHulls fitted = checkedFit({spike}, {spike.vertices, spike.triangles}, kMargin);
    EXPECT_LE(fitted.nudge, kMargin + 5e-7);
    EXPECT_LE(growth(fitted, {spike}), 1.8 * kMargin);
  }
}

TEST(RoundOutward, FarFromTheOriginItGrowsWithTheCoordinates) {
  for (double far : {10.0, 1e3, 1e4}) {
    const TriangleMesh mesh = test_shapes::moved(test_shapes::torus(1, 0.3, 12, 8), {far, -far, far});
    const std::vector<ConvexHull> hulls{hullOf(mesh)};
    const RoundedHulls fitted = checkedFit(hulls, mesh);
    EXPECT_LE(fitted.nudge, 1e-6 * far);
    EXPECT_LE(growth(fitted, hulls), 1e-5 * far);
  }
}

TEST(RoundOutward, WorksAtAnySize) {
  for (double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    const TriangleMesh mesh = scaled(test_shapes::torus(1, 0.3, 12, 8), Vector3d::Constant(scale));
    const std::vector<ConvexHull> hulls{hullOf(mesh)};
    EXPECT_LE(growth(checkedFit(hulls, mesh), hulls), 1e-5 * scale);
  }
}

// Random input.

TEST(RoundOutward, HullsOfAnyShape) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const Vector3d form(1, std::pow(10.0, -static_cast<double>(seed % 5) * 2), std::pow(10.0, -static_cast<double>(seed % 4) * 2));
    const Eigen::Matrix3d turn = random.rotation();
    const Vector3d place = seed % 3 == 0 ? Vector3d(100 * random.inCube()) : Vector3d::Zero();
    std::vector<ConvexHull> hulls;
    std::vector<TriangleMesh> parts;
    for (int h = 0; h < 3; ++h) {
      TriangleMesh part = random.soup(6 + static_cast<int>(seed) % 20, 0.3);
      for (Vector3d& v : part.vertices) v = place + turn * v.cwiseProduct(form);
      hulls.push_back(hullOf(part));
      parts.push_back(part);
    }
    const TriangleMesh mesh = test_shapes::merged(parts);
    const RoundedHulls fitted = checkedFit(hulls, mesh);
    EXPECT_EQ(fitted.completed, 0u);
    EXPECT_LE(fitted.nudge, 2e-5 * sizeOf(mesh));
    EXPECT_LE(growth(fitted, hulls), 1e-4 * sizeOf(mesh));
  }
}

TEST(RoundOutward, KeepsTheVertexCap) {
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    TriangleMesh mesh = seed % 2 ? test_shapes::sphere(1, 3) : random.soup(20, 0.3);
    const Vector3d form(1, seed % 3 == 1 ? 1e-4 : 1, seed % 4 == 2 ? 1e-5 : 1);
    const Eigen::Matrix3d turn = random.rotation();
    for (Vector3d& v : mesh.vertices) v = turn * v.cwiseProduct(form);
    for (int cap : {8, 16, 64}) checkedFit({hullOf(mesh)}, mesh, 1e-6, cap);
  }
}

/// Rounded, some slivers and even the boxes about them come out flat, and their two sides have more vertices than the cap.
TEST(RoundOutward, ASliverThatRoundingMakesFlatKeepsTheCap) {
  for (const std::uint32_t seed : {2U, 118U, 266U}) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const Eigen::Matrix3d turn = random.rotation();
    std::vector<Vector3d> points;
    for (int i = 0; i < 12; ++i) points.push_back(turn * random.inCube().cwiseProduct(Vector3d(0.9, 4e-4, 4e-7)));
    const ConvexHull sliver = convexHull(points);
    const RoundedHulls fitted = checkedFit({sliver}, {sliver.vertices, sliver.triangles}, 0, 8);
    EXPECT_LT(fitted.blunted, 2e-3);
  }
}

/// A disc far thinner than the margin has sharp vertices all around: moved as far as their faces require, they would no longer be its
/// vertices.
TEST(RoundOutward, ThinDiscUnderACapStaysADisc) {
  constexpr int kSegments = 62, kCap = 64;
  constexpr double kRadius = 0.15, kThickness = 3e-7, kMargin = 8e-6;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    const Eigen::Matrix3d turn = RandomPoints(seed).rotation();
    std::vector<Vector3d> points;
    for (int i = 0; i < kSegments; ++i) {
      const double a = 2 * test_shapes::kPi * i / kSegments;
      points.push_back(turn * Vector3d(kRadius * std::cos(a), kRadius * std::sin(a), i % 2 * kThickness));
    }
    const ConvexHull disc = convexHull(points);
    const RoundedHulls fitted = checkedFit({disc}, {disc.vertices, disc.triangles}, kMargin, kCap);
    EXPECT_LT(growth(fitted, {disc}), 0.012 * kRadius + 3 * kMargin);  // about twice that of a regular prism with 62 corners
  }
}

TEST(RoundOutward, CompletesTheCoverAtTheCapToo) {
  RandomPoints random(2);
  const TriangleMesh ball = test_shapes::sphere(1, 3);
  TriangleMesh mesh = ball;
  for (int i = 0; i < 10; ++i) {
    const int v = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(1.1 * random.onSphere());
    mesh.triangles.push_back({v, v, v});
  }
  const RoundedHulls fitted = checkedFit({hullOf(ball)}, mesh, 0, 24);
  EXPECT_LE(fitted.completed, 40u);
}

TEST(RoundOutward, SameInputGivesSameBytes) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 16, 8);
  const std::vector<ConvexHull> hulls{hullOf(mesh)};
  EXPECT_EQ(roundOutward(hulls, mesh, 1e-6, 16).hulls[0].vertices, roundOutward(hulls, mesh, 1e-6, 16).hulls[0].vertices);
}

}  // namespace
}  // namespace collision_hulls
