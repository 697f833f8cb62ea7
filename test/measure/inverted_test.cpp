#include "measure/inverted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

int count(const std::vector<char>& marks) {
  return std::accumulate(marks.begin(), marks.end(), 0);
}

TriangleMesh insideOut(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

// Degenerate input.

TEST(MayFaceInverted, NoTriangles) {
  EXPECT_TRUE(mayFaceInverted({}, {}).empty());
}

TEST(MayFaceInverted, ASheetOfTwoSidesEnclosesNothing) {
  TriangleMesh sheet = test_shapes::sheet(1, 1, 2);
  const TriangleMesh back = insideOut(sheet);
  sheet.triangles.insert(sheet.triangles.end(), back.triangles.begin(), back.triangles.end());
  EXPECT_EQ(count(mayFaceInverted(sheet, {})), 0) << "its normals leave out all directions along it";
}

// Closed-form answers.

TEST(MayFaceInverted, SimpleSurfacesDoNot) {
  for (const TriangleMesh& mesh : {test_shapes::box(1, 1, 1, 3), test_shapes::torus(), test_shapes::openBox(), test_shapes::fourSpheres()})
    EXPECT_EQ(count(mayFaceInverted(mesh, {})), 0);
}

TEST(MayFaceInverted, PartsThatCrossDoNot) {
  const TriangleMesh crossing = test_shapes::merged(
      {test_shapes::box(1, 1, 1), test_shapes::moved(test_shapes::box(1, 1, 1), {0.5, 0.3, 0.2}), test_shapes::torus()});
  EXPECT_EQ(count(mayFaceInverted(crossing, {})), 0);
}

TEST(MayFaceInverted, APartInsideOutDoesAndSoDoesWhatIsNearIt) {
  const TriangleMesh inverted = insideOut(test_shapes::moved(test_shapes::box(1, 1, 1), {5, 0, 0}));
  const TriangleMesh inside = test_shapes::moved(test_shapes::box(0.1, 0.1, 0.1), {5.5, 0.5, 0.5});
  const std::vector<char> marks = mayFaceInverted(test_shapes::merged({inverted, test_shapes::box(1, 1, 1), inside}), {});
  for (std::size_t t = 0; t < 36; ++t) EXPECT_EQ(marks[t], t < 12 || t >= 24) << t;
}

TEST(MayFaceInverted, WhatIsProvedOfOnePartIsNotTakenForAnother) {
  const TriangleMesh inverted = insideOut(test_shapes::moved(test_shapes::box(1, 1, 1), {5, 0, 0}));
  const TriangleMesh inside = test_shapes::moved(test_shapes::box(0.1, 0.1, 0.1), {5.5, 0.5, 0.5});
  EXPECT_EQ(count(mayFaceInverted(test_shapes::merged({inside, inverted}), {})), 24);
}

/// A prism whose outline crosses itself: the lobe on the right is inside out. The wall on the left, x = -3, crosses nothing.
TEST(MayFaceInverted, ALobeInsideOut) {
  const TriangleMesh lobes = test_shapes::prism({{-3, -1}, {2, 2.0 / 3}, {2, 0}, {-3, 0}}, {{0, 1, 2}, {0, 2, 3}}, 1);
  const TriangleMesh apart = test_shapes::moved(test_shapes::box(1, 1, 1), {0, 5, 0});
  const std::vector<char> marks = mayFaceInverted(test_shapes::merged({lobes, apart}), {});
  const auto isOnTheLeft = [&](int t) { return lobes.corner(t, 0).x() + lobes.corner(t, 1).x() + lobes.corner(t, 2).x() == -9; };
  for (std::size_t t = 0; t < marks.size(); ++t) EXPECT_EQ(marks[t], t < lobes.triangles.size() && !isOnTheLeft(static_cast<int>(t))) << t;
}

// Random input.

/// A sphere with some of its vertices moved so far that it crosses itself.
TriangleMesh crumpled(std::uint32_t seed) {
  RandomPoints random(seed);
  TriangleMesh mesh = test_shapes::sphere(1, 6);
  const Vector3d about = random.onSphere();
  const double reach = random.number(0.2, 1);
  for (Vector3d& v : mesh.vertices)
    if ((v - about).norm() < reach) v += random.inCube(0.6);
  if (seed % 3 == 0) return insideOut(mesh);
  if (seed % 3 == 1) return mesh;
  return test_shapes::merged({mesh, test_shapes::moved(test_shapes::sphere(0.5, 3), random.inCube(1))});
}

TEST(MayFaceInverted, NothingInsideOutLiesBeforeTheOthers) {
  int sure = 0, unsure = 0, negative = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const TriangleMesh mesh = crumpled(seed);
    const std::vector<char> marks = mayFaceInverted(mesh, {});
    const TriangleBvh tree(mesh);
    RandomPoints random(seed);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const int t = static_cast<int>(i);
      const Vector3d a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2), normal = (b - a).cross(c - a).normalized();
      for (int k = 0; k < 10; ++k) {
        const bool is_negative = tree.signedCrossings(random.inTriangle(a, b, c) + 1e-6 * normal) < 0;
        EXPECT_FALSE(is_negative && !marks[i]) << "triangle " << t;
        negative += is_negative;
      }
      ++(marks[i] ? unsure : sure);
    }
  }
  EXPECT_GT(sure, 5000);
  EXPECT_GT(unsure, 5000);
  EXPECT_GT(negative, 10000);
}

}  // namespace
}  // namespace collision_hulls
