#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

double distanceTo(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& p) {
  return (closestPoint(a, b, c, p) - p).norm();
}

double distanceToSegment(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0;
  return (a + t * (b - a) - p).norm();
}

TEST(ClosestPoint, DegenerateTriangles) {
  const Vector3d a(1, 2, 3), b(4, 2, 3), p(2, 6, 3);
  EXPECT_EQ(closestPoint(a, a, a, p), a);
  EXPECT_EQ(closestPoint(a, a, b, p), Vector3d(2, 2, 3));
  EXPECT_EQ(closestPoint(a, b, a, p), Vector3d(2, 2, 3));
  EXPECT_EQ(closestPoint(b, a, a, p), Vector3d(2, 2, 3));
  EXPECT_EQ(closestPoint(a, b, (a + b) / 2, p), Vector3d(2, 2, 3));
  EXPECT_EQ(closestPoint((a + b) / 2, a, b, p), Vector3d(2, 2, 3));
  EXPECT_EQ(closestPoint(a, (a + b) / 2, b, Vector3d(9, 2, 3)), b);
}

TEST(ClosestPoint, EachOfTheSevenRegions) {
  const Vector3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  EXPECT_EQ(closestPoint(a, b, c, {1, 1, 5}), Vector3d(1, 1, 0));
  EXPECT_EQ(closestPoint(a, b, c, {-1, -1, 5}), a);
  EXPECT_EQ(closestPoint(a, b, c, {9, 0, 5}), b);
  EXPECT_EQ(closestPoint(a, b, c, {0, 9, 5}), c);
  EXPECT_EQ(closestPoint(a, b, c, {1, -1, 5}), Vector3d(1, 0, 0));
  EXPECT_EQ(closestPoint(a, b, c, {-1, 1, 5}), Vector3d(0, 1, 0));
  EXPECT_EQ(closestPoint(a, b, c, {4, 4, 5}), Vector3d(2, 2, 0));
}

/// A triangle with corners (0, 0), (1, 0) and (x, h) in a plane, and a point at (t, s) in that plane and d above it: finding the nearest
/// point is a two-dimensional problem, where thin triangles do no harm.
void expectExact(const Eigen::Isometry3d& pose, double x, double h, const Vector3d& p, double scale) {
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(x, h, 0), flat(p.x(), p.y(), 0);
  const auto left = [](const Vector3d& u, const Vector3d& v) { return u.x() * v.y() - u.y() * v.x() >= 0; };
  const bool inside = left(b - a, flat - a) && left(c - b, flat - b) && left(a - c, flat - c);
  const double edges = std::min({distanceToSegment(a, b, flat), distanceToSegment(b, c, flat), distanceToSegment(c, a, flat)});
  const double expected = scale * std::hypot(inside ? 0 : edges, p.z());
  const auto at = [&](const Vector3d& v) -> Vector3d { return pose * (scale * v); };
  const double tolerance = 2e-15 * scale * (1 + p.norm());
  EXPECT_NEAR(distanceTo(at(a), at(b), at(c), at(p)), expected, tolerance) << "x " << x << ", h " << h << ", p " << p.transpose();
  EXPECT_NEAR(distanceTo(at(b), at(c), at(a), at(p)), expected, tolerance) << "x " << x << ", h " << h << ", p " << p.transpose();
  EXPECT_NEAR(distanceTo(at(c), at(b), at(a), at(p)), expected, tolerance) << "x " << x << ", h " << h << ", p " << p.transpose();
}

TEST(ClosestPoint, IsExactForTrianglesOfAnyThinness) {
  RandomPoints random(1);
  for (int thinness = 0; thinness <= 18; ++thinness)
    for (int i = 0; i < 300; ++i) {
      const double h = std::pow(10.0, -thinness), far = std::pow(10.0, random.number(-3, 1));
      const Eigen::Isometry3d pose(random.rotation());
      const double x = i % 4 == 0 ? random.index(2) + random.number(-h, h) : random.number(0, 1);
      Vector3d p(random.number(-0.2, 1.2), random.number(-0.5, 1.5) * h, random.number(-far, far));
      if (i % 3 == 1) p = random.inCube(far) + Vector3d(0.5, 0, 0);
      if (i % 3 == 2) p.z() *= h;
      expectExact(pose, x, h, p, i % 2 ? 1 : 1e-3);
    }
}

// Of a box's distance, single precision has few digits left where all that matters is far from the middle.
TEST(TriangleBvh, NearestOfSheetsThatAreFarOutAndCloseTogether) {
  RandomPoints random(4);
  for (const double size : {1e-3, 1.0, 1e3, 1e39}) {
    const TriangleMesh sheet = scaled(test_shapes::singleTriangle(), Vector3d::Constant(size));
    const auto height = [&] { return size * (1 - 4e-6 * random.number(0, 1)); };
    TriangleMesh mesh = sheet;
    for (int i = 0; i < 40; ++i) append(mesh, test_shapes::moved(sheet, {0, 0, height()}));
    const TriangleBvh bvh(mesh);
    for (int i = 0; i < 1000; ++i) {
      const Vector3d p(0.2 * size, 0.2 * size, height());
      double least = std::numeric_limits<double>::infinity();
      for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        least = std::min(least, distanceTo(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), p));
      EXPECT_EQ(bvh.nearest(p).distance, least) << size;
    }
  }
}

}  // namespace
}  // namespace collision_hulls
