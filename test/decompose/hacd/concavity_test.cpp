#include "decompose/hacd/concavity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "collision_hulls/decompose/hacd.h"
#include "decompose/hacd/triangle_concavity.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;
const double kInfinity = std::numeric_limits<double>::infinity();

std::vector<int> all(const TriangleMesh& mesh) {
  std::vector<int> triangles(mesh.triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) triangles[t] = static_cast<int>(t);
  return triangles;
}

TEST(Concavity, NoneForAtMostOneTriangle) {
  EXPECT_EQ(concavity(test_shapes::singleTriangle(), {}), 0);
  EXPECT_EQ(concavity(test_shapes::singleTriangle(), {0}), 0);
}

TEST(Concavity, NoneForConvexSurfaces) {
  for (const TriangleMesh& mesh : {test_shapes::box(1, 2, 3, 3), test_shapes::sphere(2, 4), test_shapes::sheet(1, 1, 4)})
    EXPECT_EQ(concavity(mesh, all(mesh)), 0);
}

/// Two slopes of 45 degrees that meet in the y axis, seen from above.
TriangleMesh valley() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 1, 1}, {-1, 1, 1}};
  mesh.triangles = {{0, 2, 4}, {0, 4, 1}, {0, 1, 5}, {0, 5, 3}};
  return mesh;
}

TEST(Concavity, FollowsFromTheAngleOfAValley) {
  // The hull's lid is at z = 1. A ray from the bottom leaves the hull at the end of the other slope, after sqrt(2).
  TriangleMesh mesh = valley();
  EXPECT_NEAR(concavity(mesh, all(mesh)), std::sqrt(2.0), 1e-6);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);  // seen from below it is a ridge
  EXPECT_EQ(concavity(mesh, all(mesh)), 0);
}

TEST(Concavity, NoneForAFlatNonConvexBand) {
  const TriangleMesh channel = test_shapes::uChannel();
  std::vector<int> top;
  for (std::size_t t = 0; t < channel.triangles.size(); ++t) {
    const int triangle = static_cast<int>(t);
    if (channel.corner(triangle, 0).z() == 2 && channel.corner(triangle, 1).z() == 2 && channel.corner(triangle, 2).z() == 2)
      top.push_back(triangle);
  }
  ASSERT_EQ(top.size(), 6u);
  EXPECT_EQ(concavity(channel, top), 0);
}

TEST(Concavity, NeverDecreasesAsASurfaceGrows) {
  const unsigned seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (const TriangleMesh& mesh : {test_shapes::torus(1, 0.3, 12, 8), test_shapes::openBox(1, 1, 1, 0.1, 2), test_shapes::flange(4)}) {
    std::vector<int> order = all(mesh);
    std::shuffle(order.begin(), order.end(), random);
    const ConcavityMeasure measure(mesh);
    Patch grown = measure.patch(order[0]);
    for (std::size_t i = 1; i < 60; ++i) {
      const double before = grown.concavity;
      const Patch next = measure.patch(order[i]);
      grown = measure.unite(std::move(grown), next, measure.ofUnion(grown, next, 0, kInfinity));
      EXPECT_GE(grown.concavity, before);
      // From scratch, without what is known about the parts.
      const ConvexHull hull = convexHull(measure.positions(grown.points));
      const ExitFaces faces(hull);
      double fresh = 0;
      for (int t : grown.triangles) {
        const Corners corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
        const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        fresh = std::max(fresh, concavityOfTriangle(faces, corners, normal));
      }
      EXPECT_NEAR(grown.concavity, fresh, 2 * ConcavityMeasure::kNegligible * diagonal(mesh));
    }
  }
}

Patch patchOf(const ConcavityMeasure& measure, int first, int last) {
  Patch grown = measure.patch(first);
  for (int t = first + 1; t < last; ++t) {
    const Patch next = measure.patch(t);
    ConcavityMeasure::Union both = measure.ofUnion(grown, next, 0, kInfinity);
    grown = measure.unite(std::move(grown), next, std::move(both));
  }
  return grown;
}

TEST(Concavity, OfLargePatchesThatFaceEachOther) {
  // Strips across a tube that turns by a quarter: rays of one leave through the hull of the other.
  const TriangleMesh mesh = test_shapes::torus(1, 0.5, 24, 32);
  const ConcavityMeasure measure(mesh);
  for (const int size : {64, 128, 256}) {
    const Patch a = patchOf(measure, 0, size), b = patchOf(measure, size, 2 * size);
    ASSERT_GT(a.points.size(), 50u);
    std::vector<int> all(static_cast<std::size_t>(2 * size));
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
    std::vector<Eigen::Vector3d> points;
    for (const int t : all)
      for (int k = 0; k < 3; ++k) points.push_back(mesh.corner(t, k));
    const ConvexHull hull = convexHull(points);
    const ExitFaces faces(hull);
    double fresh = 0;
    for (const int t : all) {
      const Corners corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
      const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
      fresh = std::max(fresh, concavityOfTriangle(faces, corners, normal));
    }
    ASSERT_GT(fresh, std::max(a.concavity, b.concavity) + 1e-3);
    EXPECT_NEAR(measure.ofUnion(a, b, 0, kInfinity).value, fresh, 1e-8) << size;
  }
}

TEST(Concavity, HeightsAreUpperBounds) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.5, 24, 48);
  const ConcavityMeasure measure(mesh);
  Patch a = patchOf(measure, 0, 500);
  const Patch b = patchOf(measure, 500, 1000);
  ASSERT_GT(b.points.size(), 150u);
  ConcavityMeasure::Union both = measure.ofUnion(a, b, 0, kInfinity);
  both.value = 0;  // so that no height is left to the boxes
  const Patch s = measure.unite(std::move(a), b, std::move(both));
  const std::vector<Eigen::Vector3d> points = measure.positions(s.points);
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const Eigen::Vector3d &p = mesh.corner(s.triangles[i], 0), &q = mesh.corner(s.triangles[i], 1), &r = mesh.corner(s.triangles[i], 2);
    const Eigen::Vector3d normal = (q - p).cross(r - p).normalized();
    double rise = 0;
    for (const Eigen::Vector3d& x : points) rise = std::max(rise, normal.dot(x - p));
    EXPECT_GE(s.heights[i], rise - 1e-12) << i;
  }
}

TEST(Concavity, BeyondTheLimitIsALowerBoundAboveIt) {
  const ConcavityMeasure measure(valley());
  const double whole = measure.ofUnion(measure.patch(1), measure.patch(2), 0, kInfinity).value;
  ASSERT_GT(whole, 0.5);
  const ConcavityMeasure::Union stopped = measure.ofUnion(measure.patch(1), measure.patch(2), 0, whole / 2);
  EXPECT_GT(stopped.value, whole / 2);
  EXPECT_LE(stopped.value, whole);
  EXPECT_TRUE(stopped.points.empty());
}

}  // namespace
}  // namespace collision_hulls
