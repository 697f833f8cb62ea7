// Tests src/geometry/triangle_bvh_patch.cpp: metBy() is null only if the patch meets nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

using Patch = std::array<Vector3d, 3>;

/// Whether the segment ab crosses the triangle.
bool crosses(const Vector3d& a, const Vector3d& b, const Patch& t) {
  const auto volume = [](const Vector3d& p, const Vector3d& q, const Vector3d& r, const Vector3d& s) {
    return (q - p).cross(r - p).dot(s - p);
  };
  if ((volume(t[0], t[1], t[2], a) > 0) == (volume(t[0], t[1], t[2], b) > 0)) return false;
  const bool left = volume(a, b, t[0], t[1]) > 0;
  return (volume(a, b, t[1], t[2]) > 0) == left && (volume(a, b, t[2], t[0]) > 0) == left;
}

/// Two triangles in general position meet where an edge of one crosses the other.
bool meet(const Patch& s, const Patch& t) {
  bool result = false;
  for (std::size_t i = 0; i < 3; ++i) result = result || crosses(s[i], s[(i + 1) % 3], t) || crosses(t[i], t[(i + 1) % 3], s);
  return result;
}

TEST(TriangleBvh, WhatAPatchMeets) {
  int met = 0, hardly_told = 0, free = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const std::vector<TriangleMesh> meshes{test_shapes::torus(1, 0.3, 16, 10), test_shapes::openBox(1, 1, 1, 0.1, 3), random.soup(60, 0.4),
                                           test_shapes::sphere(100, 4)};
    for (const TriangleMesh& mesh : meshes) {
      const double scale = boundingBox(mesh).sizes().maxCoeff() / 2;
      const TriangleBvh bvh(mesh);
      for (int i = 0; i < 200; ++i) {
        const Vector3d p = scale * random.inCube(1.2);
        const double size = scale * std::pow(10.0, random.number(-3, 0.3));
        const Patch patch{p + random.inCube(size), p + random.inCube(size), p + random.inCube(size)};
        bool expected = false;
        for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
          expected = expected || meet(patch, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
        const Patch* found = bvh.metBy(patch);
        if (expected) {
          ASSERT_TRUE(found);
          ++met;
        } else {
          found ? ++hardly_told : ++free;
        }
      }
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(free, 2000);
  EXPECT_LT(hardly_told, 0.01 * free) << "it need not be exact, but nearly so";
}

Eigen::Isometry3d askew() {
  return Eigen::Isometry3d(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
}

// From inside to outside, along a line: rounding alone decides on such a patch's normal.
TEST(TriangleBvh, ASliverMeetsWhatItCrosses) {
  RandomPoints random(4);
  const Eigen::Isometry3d turn = askew();
  const TriangleBvh bvh(transformed(test_shapes::box(1, 1, 1, 4), turn));
  const auto missed = [&](const Vector3d& from, const Vector3d& to, double width) {
    const Vector3d between = from + random.number(0, 1) * (to - from) + random.inCube(width);
    const std::array<Patch, 4> patches{Patch{from, between, to}, Patch{between, to, from}, Patch{to, from, between}, Patch{from, to, to}};
    return std::count_if(patches.begin(), patches.end(), [&](const Patch& patch) { return !bvh.metBy(patch); });
  };
  for (int i = 0; i < 2000; ++i) {
    const Vector3d inside = turn * (Vector3d::Constant(0.5) + random.inCube(0.4));
    const Vector3d outside = turn * Vector3d::Constant(0.5) + random.number(1, 2) * random.onSphere();
    EXPECT_EQ(missed(inside, outside, 0), 0);
    EXPECT_EQ(missed(inside, outside, std::pow(10.0, random.number(-17, -5))), 0);
  }
}

// In the plane of a face, the heights above it are rounding errors.
TEST(TriangleBvh, APatchThatTouchesTheSurfaceMeetsIt) {
  RandomPoints random(3);
  const Eigen::Isometry3d turn = askew();
  const TriangleBvh bvh(transformed(test_shapes::box(1, 1, 1, 4), turn));
  for (int i = 0; i < 300; ++i) {
    const auto on = [&](double z) { return Vector3d(turn * Vector3d(random.number(0.1, 0.9), random.number(0.1, 0.9), z)); };
    EXPECT_TRUE(bvh.metBy({on(1), on(1), on(1)}));
    EXPECT_TRUE(bvh.metBy({on(1), on(1.5), on(1.5)})) << "a corner";
    EXPECT_TRUE(bvh.metBy({on(1), on(1), on(0.5)})) << "an edge";
    EXPECT_FALSE(bvh.metBy({on(0.999), on(0.999), on(0.001)})) << "inside";
    EXPECT_FALSE(bvh.metBy({on(1 - 1e-7), on(1 - 1e-7), on(1 - 1e-7)})) << "closely below the face";
    EXPECT_TRUE(bvh.metBy({on(1 - 1e-9), on(1 - 1e-9), on(1 - 1e-9)})) << "within the blur";
  }
}

}  // namespace
}  // namespace collision_hulls
