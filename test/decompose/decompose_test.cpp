#include "collision_hulls/decompose/decompose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_hulls/measure/measures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

DecomposeOptions with(Method method, const TriangleMesh& mesh) {
  DecomposeOptions options;
  options.method = method;
  options.tolerance = 0.03 * diagonal(mesh);
  return options;
}

Decomposition run(const TriangleMesh& mesh, Method method) {
  return decompose(repair(mesh), with(method, mesh));
}

void expectCovers(const Decomposition& result, const TriangleMesh& mesh) {
  EXPECT_LE(uncovered(mesh, result.hulls), 1e-12 * (diagonal(mesh) + boundingBox(mesh).center().norm()));
}

void expectError(ErrorCode code, const RepairedMesh& mesh, const DecomposeOptions& options) {
  try {
    decompose(mesh, options);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
  }
}

TEST(Method, NamesAreReadBack) {
  for (Method method : allMethods()) EXPECT_EQ(methodNamed(name(method)), method);
  EXPECT_FALSE(methodNamed("HACD"));
}

TEST(Decompose, RejectsAnEmptyMesh) {
  for (Method method : allMethods()) {
    DecomposeOptions options;
    options.method = method;
    options.tolerance = 1;
    expectError(ErrorCode::kEmptyMesh, {}, options);
  }
}

TEST(Decompose, RejectsOptionsOutOfRange) {
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  const RepairedMesh mesh = repair(box);
  DecomposeOptions filled = with(Method::kAcd, box);
  filled.fill = true;
  expectError(ErrorCode::kBadOption, mesh, filled);
  for (double tolerance : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    DecomposeOptions options = with(Method::kHacd, box);
    options.tolerance = tolerance;
    expectError(ErrorCode::kBadOption, mesh, options);
  }
  DecomposeOptions options = with(Method::kHacd, box);
  options.max_hulls = -1;
  expectError(ErrorCode::kBadOption, mesh, options);
  options = with(Method::kHacd, box);
  options.max_vertices = 7;
  expectError(ErrorCode::kBadOption, mesh, options);
  options = with(Method::kHacd, box);
  options.effort = Effort::kBest;
  expectError(ErrorCode::kBadOption, mesh, options);
  options = with(static_cast<Method>(77), box);
  expectError(ErrorCode::kBadOption, mesh, options);
  options = with(Method::kCertified, box);
  options.effort = static_cast<Effort>(77);
  expectError(ErrorCode::kBadOption, mesh, options);
  options = with(Method::kCertified, box);
  options.regions.emplace_back();
  expectError(ErrorCode::kBadOption, mesh, options);
}

// The work would never end.
TEST(Decompose, RefusesTolerancesBelowTheCoordinatesResolution) {
  const TriangleMesh bracket = test_shapes::lBracket();
  const RepairedMesh mesh = repair(bracket);
  for (const Method method : allMethods()) {
    DecomposeOptions options = with(method, bracket);
    options.tolerance = 0.99e-6 * diagonal(bracket);
    if (method == Method::kSingleHull || method == Method::kBoundingBox)
      EXPECT_NO_THROW(decompose(mesh, options)) << "which ignore it";
    else
      expectError(ErrorCode::kBadOption, mesh, options);
  }
}

TEST(Decompose, EveryMethodCoversEveryShape) {
  for (const TriangleMesh& mesh : {test_shapes::singleTriangle(), test_shapes::sheet(1, 2, 3), test_shapes::lBracket(),
                                   test_shapes::uChannel(), test_shapes::openBox(), test_shapes::torus(), test_shapes::flange(),
                                   test_shapes::fourSpheres(), test_shapes::moved(test_shapes::torus(1e-3, 3e-4), {10, -20, 5})})
    for (Method method : allMethods()) {
      SCOPED_TRACE(name(method));
      const Decomposition result = run(mesh, method);
      expectCovers(result, mesh);
      for (const ConvexHull& hull : result.hulls) EXPECT_LE(hull.vertices.size(), 64u);
      if (method == Method::kSingleHull || method == Method::kBoundingBox) {
        EXPECT_EQ(result.hulls.size(), 1u);
      }
    }
}

TEST(Decompose, OnlyLoosePointsAreCovered) {
  RepairedMesh mesh;
  mesh.loose = test_shapes::loosePoints({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}});
  for (Method method : allMethods()) {
    SCOPED_TRACE(name(method));
    DecomposeOptions options;
    options.method = method;
    options.tolerance = 1;
    const Decomposition result = decompose(mesh, options);
    for (const ConvexHull& hull : result.hulls) EXPECT_GT(hull.thickness, 0);
    for (const Segment& point : mesh.loose) {
      const auto holds = [&point](const ConvexHull& hull) { return planeDistance(hull, point[0]) <= 1e-12; };
      EXPECT_TRUE(std::any_of(result.hulls.begin(), result.hulls.end(), holds));
    }
  }
}

TEST(Decompose, LoosePointsGoToTheNearestHull) {
  RepairedMesh mesh = repair(test_shapes::fourSpheres());
  mesh.loose = test_shapes::loosePoints({{3.5, 2, 0}, {2, 2, 0.5}});  // one beside a sphere, one inside it
  DecomposeOptions options = with(Method::kHacd, mesh.mesh);
  const Decomposition result = decompose(mesh, options);
  ASSERT_EQ(result.hulls.size(), 4u);
  int changed = 0;
  for (const ConvexHull& hull : result.hulls) {
    if (boundingBox(hull).max().x() > 3.4) {
      ++changed;
      EXPECT_GT(boundingBox(hull).min().y(), 0);
    }
  }
  EXPECT_EQ(changed, 1);
}

// Flat triangles from one box to another, with a loose end: part of the surface like any other.
TEST(Decompose, AWireOfFlatTrianglesIsCovered) {
  TriangleMesh mesh = test_shapes::merged({test_shapes::box(1, 1, 1), test_shapes::moved(test_shapes::box(1, 1, 1), {4, 0, 0})});
  const int first = static_cast<int>(mesh.vertices.size());
  for (const double x : {1.0, 2.0, 4.0}) mesh.vertices.emplace_back(x, 0.5, 0.5);
  mesh.vertices.emplace_back(2, 3, 0.5);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first + 1, first + 3, first + 3});
  const RepairedMesh repaired = repair(mesh);
  for (Method method : allMethods()) {
    SCOPED_TRACE(name(method));
    const DecomposeOptions options = with(method, repaired.mesh);
    const Decomposition result = decompose(repaired, options);
    EXPECT_LE(uncovered(mesh, result.hulls), 1e-9);
    if (method != Method::kCertified) continue;
    EXPECT_LE(result.hulls.size(), 4u);
    EXPECT_LE(protrusion(result.hulls, Solid(repaired), 0.01 * options.tolerance).bound, options.tolerance);
  }
}

TEST(SingleHull, IsTheHullOfTheWholeMesh) {
  DecomposeOptions options;
  options.method = Method::kSingleHull;
  const Decomposition result = decompose(repair(test_shapes::lBracket(1, 0.1, 2)), options);
  ASSERT_EQ(result.hulls.size(), 1u);
  EXPECT_NEAR(volume(result.hulls[0]), 2 * (1 - 0.9 * 0.9 / 2), 1e-9);
  EXPECT_FALSE(result.capped);
}

TEST(BoundingBox, FindsARotatedBox) {
  const Eigen::Isometry3d pose(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const Decomposition result = run(transformed(test_shapes::box(1, 2, 3, 3), pose), Method::kBoundingBox);
  ASSERT_EQ(result.hulls.size(), 1u);
  EXPECT_EQ(result.hulls[0].vertices.size(), 8u);
  EXPECT_NEAR(volume(result.hulls[0]), 6, 1e-9);
}

TEST(BoundingBox, IsFlushWithAFace) {
  // The smallest box around a right-angled prism is flush with its two short sides.
  const Eigen::Isometry3d pose(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, -1, 0.5).normalized()));
  const TriangleMesh prism = test_shapes::prism({{0, 0}, {4, 0}, {0, 3}}, {{0, 1, 2}}, 2);
  EXPECT_NEAR(volume(run(transformed(prism, pose), Method::kBoundingBox).hulls[0]), 24, 1e-9);
}

TEST(BoundingBox, FlatInputGivesAThinBox) {
  const Decomposition result = run(test_shapes::sheet(1, 2), Method::kBoundingBox);
  EXPECT_EQ(result.hulls[0].vertices.size(), 8u);
  EXPECT_GT(result.hulls[0].thickness, 0);
  EXPECT_LT(volume(result.hulls[0]), 1e-4);
}

TEST(MaxVertices, CapsEveryHullAndIsReported) {
  const TriangleMesh sphere = test_shapes::sphere(1, 5);
  for (Method method : {Method::kHacd, Method::kSingleHull}) {
    DecomposeOptions options = with(method, sphere);
    options.max_vertices = 20;
    const Decomposition result = decompose(repair(sphere), options);
    EXPECT_TRUE(result.capped);
    for (const ConvexHull& hull : result.hulls) EXPECT_LE(hull.vertices.size(), 20u);
    expectCovers(result, sphere);
    options.max_vertices = 0;
    const Decomposition whole = decompose(repair(sphere), options);
    EXPECT_FALSE(whole.capped);
    EXPECT_EQ(whole.hulls[0].vertices.size(), 252u);
  }
}

TEST(MaxHulls, MergesNearComponentsFirst) {
  TriangleMesh two_pairs;
  std::vector<TriangleMesh> parts;
  for (double x : {0.0, 1.1, 10.0, 11.1}) parts.push_back(test_shapes::moved(test_shapes::box(1, 1, 1), {x, 0, 0}));
  two_pairs = test_shapes::merged(parts);
  DecomposeOptions options = with(Method::kHacd, two_pairs);
  options.max_hulls = 4;
  EXPECT_FALSE(decompose(repair(two_pairs), options).capped);
  options.max_hulls = 2;
  const Decomposition result = decompose(repair(two_pairs), options);
  EXPECT_TRUE(result.capped);
  ASSERT_EQ(result.hulls.size(), 2u);
  for (const ConvexHull& hull : result.hulls) EXPECT_NEAR(volume(hull), 2.1, 1e-6);
  expectCovers(result, two_pairs);
}

TEST(MaxHulls, IsReachedFromManyClusters) {
  for (const TriangleMesh& mesh : {test_shapes::flange(), test_shapes::torus(), test_shapes::fourSpheres()}) {
    for (int cap : {1, 3}) {
      DecomposeOptions options = with(Method::kHacd, mesh);
      options.max_hulls = cap;
      const Decomposition result = decompose(repair(mesh), options);
      EXPECT_EQ(result.hulls.size(), static_cast<std::size_t>(cap));
      EXPECT_TRUE(result.capped);
      expectCovers(result, mesh);
    }
  }
}

TEST(Decompose, SameInputGivesSameBytes) {
  const TriangleMesh mesh = test_shapes::flange();
  for (Method method : allMethods()) {
    const Decomposition a = run(mesh, method), b = run(mesh, method);
    ASSERT_EQ(a.hulls.size(), b.hulls.size());
    for (std::size_t h = 0; h < a.hulls.size(); ++h) {
      EXPECT_EQ(a.hulls[h].vertices, b.hulls[h].vertices);
      EXPECT_EQ(a.hulls[h].triangles, b.hulls[h].triangles);
    }
  }
}

TEST(Decompose, CancelledBeforehand) {
  const TriangleMesh mesh = test_shapes::lBracket();
  for (Method method : allMethods()) {
    RunControl control;
    control.cancel();
    try {
      decompose(repair(mesh), with(method, mesh), control);
      FAIL() << name(method);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kCancelled);
    }
  }
}

TEST(Decompose, ProgressEndsAtOne) {
  for (Method method : allMethods()) {
    RunControl control;
    double last = 0;
    control.progress = [&](double fraction) {
      EXPECT_GE(fraction, last);
      last = fraction;
    };
    const TriangleMesh mesh = test_shapes::lBracket();
    decompose(repair(mesh), with(method, mesh), control);
    EXPECT_EQ(last, 1);
  }
}

}  // namespace
}  // namespace collision_hulls
