#include "collision_hulls/geometry/triangle_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

// Degenerate input.

TEST(TriangleMesh, AllMeasuresOfAnEmptyMeshAreZero) {
  const TriangleMesh empty, points{{{1, 2, 3}, {4, 5, 6}}, {}};
  for (const TriangleMesh& mesh : {empty, points}) {
    EXPECT_TRUE(boundingBox(mesh).isEmpty());
    EXPECT_EQ(diagonal(mesh), 0);
    EXPECT_EQ(area(mesh), 0);
    EXPECT_EQ(signedVolume(mesh), 0);
  }
}

TEST(TriangleMesh, IgnoresUnusedVertices) {
  TriangleMesh mesh = test_shapes::singleTriangle();
  mesh.vertices.push_back({100, 100, 100});
  EXPECT_EQ(boundingBox(mesh).max(), Vector3d(1, 1, 0));
  EXPECT_DOUBLE_EQ(diagonal(mesh), std::sqrt(2.0));
}

TEST(CheckMesh, LetsWhatIsUsedDecide) {
  const auto code = [](const TriangleMesh& mesh) {
    try {
      check(mesh);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;  // nothing was thrown
  };
  TriangleMesh mesh = test_shapes::singleTriangle();
  mesh.vertices.emplace_back(0, std::nan(""), 0);
  EXPECT_EQ(code(mesh), ErrorCode::kInternal) << "no triangle has that vertex";
  mesh.triangles.push_back({0, 1, 3});
  EXPECT_EQ(code(mesh), ErrorCode::kNonFiniteCoordinate);
  for (const int wrong : {-1, 4}) {
    mesh.triangles.back() = {0, 1, wrong};
    EXPECT_EQ(code(mesh), ErrorCode::kIndexOutOfRange);
  }
  EXPECT_EQ(code({}), ErrorCode::kInternal);
}

TEST(TriangleMesh, RejectsAZeroOrNonFiniteScale) {
  for (double bad : {0.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    try {
      scaled(test_shapes::box(1, 1, 1), {1, bad, 1});
      FAIL() << bad;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadScale);
      EXPECT_NE(std::string(error.what()).find("'1 " + decimal(bad) + " 1'; give three finite numbers other than 0"), std::string::npos)
          << error.what();
    }
  }
}

TEST(TriangleMesh, AppendingKeepsEachTrianglesCorners) {
  const TriangleMesh first = test_shapes::singleTriangle(), more = test_shapes::box(1, 2, 3);
  TriangleMesh all = first;
  append(all, more);
  ASSERT_EQ(all.triangles.size(), 1 + more.triangles.size());
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(all.corner(0, k), first.corner(0, k));
    for (int t = 0; t < static_cast<int>(more.triangles.size()); ++t) EXPECT_EQ(all.corner(1 + t, k), more.corner(t, k));
  }
  append(all, TriangleMesh());
  EXPECT_EQ(all.triangles.size(), 1 + more.triangles.size());
}

// Closed-form answers.

TEST(TriangleMesh, MeasuresABox) {
  const TriangleMesh box = test_shapes::moved(test_shapes::box(1, 2, 3, 4), {10, -20, 30});
  EXPECT_NEAR(area(box), 22, 1e-12);
  EXPECT_NEAR(signedVolume(box), 6, 1e-12);
  EXPECT_NEAR(diagonal(box), std::sqrt(14.0), 1e-12);
}

TEST(TriangleMesh, VolumeFarFromTheOrigin) {
  const TriangleMesh box = test_shapes::moved(test_shapes::box(1, 1, 1, 4), {1e6, 1e6, 1e6});
  EXPECT_NEAR(signedVolume(box), 1, 1e-8);
}

TEST(TriangleMesh, AnInwardMeshHasNegativeVolume) {
  TriangleMesh box = test_shapes::box(1, 2, 3);
  for (Triangle& t : box.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(signedVolume(box), -6, 1e-12);
}

TEST(TriangleMesh, MirroringKeepsOutsideOutside) {
  const TriangleMesh box = test_shapes::box(1, 2, 3);
  EXPECT_NEAR(signedVolume(scaled(box, {2, 1, 1})), 12, 1e-12);
  EXPECT_NEAR(signedVolume(scaled(box, {-2, 1, 1})), 12, 1e-12);
  EXPECT_NEAR(signedVolume(scaled(box, {-2, -1, 1})), 12, 1e-12);
  EXPECT_NEAR(signedVolume(scaled(box, {-2, -1, -1})), 12, 1e-12);
}

TEST(TriangleMesh, RigidTransformsPreserveMeasures) {
  const TriangleMesh torus = test_shapes::torus(1, 0.3, 24, 12);
  Eigen::Isometry3d pose(Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()));
  pose.translation() = Vector3d(4, 5, 6);
  const TriangleMesh turned = transformed(torus, pose);
  EXPECT_NEAR(area(turned), area(torus), 1e-12);
  EXPECT_NEAR(signedVolume(turned), signedVolume(torus), 1e-12);
  EXPECT_NEAR((turned.vertices[7] - pose * torus.vertices[7]).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace collision_hulls
