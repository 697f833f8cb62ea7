#include "collision_hulls/geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using test_shapes::RandomPoints;

double sizeOf(const Points& points) {
  double size = 0;
  for (const Vector3d& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
  return size;
}

double extentOf(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) box.extend(p);
  return box.diagonal().norm();
}

/// Each directed edge occurs once, and so does its opposite: by Euler's formula this is one closed surface of genus 0.
void expectClosed(const ConvexHull& hull) {
  std::map<std::pair<int, int>, int> edges;
  std::vector<char> used(hull.vertices.size(), 0);
  for (const Triangle& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
      used[static_cast<std::size_t>(t[k])] = 1;
    }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), 1), static_cast<long>(hull.vertices.size()));
  EXPECT_EQ(hull.triangles.size(), 2 * hull.vertices.size() - 4);
}

/// How far the intersection of the faces reaches beyond the triangles, along their normals. Skips slivers, whose normals are noise.
double furthestBeyondSurface(const ConvexHull& hull, RandomPoints& random) {
  double most = 0;
  for (const Triangle& t : hull.triangles) {
    const auto at = [&](std::size_t k) -> const Vector3d& { return hull.vertices[static_cast<std::size_t>(t[k])]; };
    const Vector3d cross = (at(1) - at(0)).cross(at(2) - at(0)), p = random.inTriangle(at(0), at(1), at(2));
    if (cross.norm() < 1e-6 * std::max((at(1) - at(0)).squaredNorm(), (at(2) - at(0)).squaredNorm())) continue;
    double exit = std::numeric_limits<double>::infinity();
    for (const HalfSpace& f : hull.faces) {
      const double cosine = f.normal.dot(cross.normalized());
      if (cosine > 0) exit = std::min(exit, -f.distance(p) / cosine);
    }
    most = std::max(most, exit);
  }
  return most;
}

/// What the header promises for every hull.
void expectHull(const ConvexHull& hull, const Points& points) {
  RandomPoints random(7);
  expectClosed(hull);
  const double rounding = 1e-15 * std::max(sizeOf(points), sizeOf(hull.vertices)), extent = extentOf(hull.vertices);
  double beyond = -1, off = 0;
  for (const Vector3d& p : points) beyond = std::max(beyond, planeDistance(hull, p));
  EXPECT_LE(beyond, rounding) << "a point lies outside a face";
  for (const HalfSpace& f : hull.faces) EXPECT_NEAR(f.normal.norm(), 1, 1e-14);
  // Each triangle lies on some face and points outward, up to `slack`, which is small.
  EXPECT_LE(hull.slack, 1e-9 * extent + 16 * rounding);
  for (const Triangle& t : hull.triangles) {
    double best = std::numeric_limits<double>::infinity();
    const auto at = [&](std::size_t k) -> const Vector3d& { return hull.vertices[static_cast<std::size_t>(t[k])]; };
    const Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
    const bool sliver = normal.norm() < 1e-6 * std::max((at(1) - at(0)).squaredNorm(), (at(2) - at(0)).squaredNorm());
    for (const HalfSpace& f : hull.faces) {
      if (!sliver && normal.dot(f.normal) < 0) continue;
      best = std::min(best, std::max({std::abs(f.distance(at(0))), std::abs(f.distance(at(1))), std::abs(f.distance(at(2)))}));
    }
    off = std::max(off, best);
  }
  EXPECT_LE(off, hull.slack + 2 * rounding) << "a triangle does not lie on any face";
  EXPECT_LE(furthestBeyondSurface(hull, random), 2 * hull.slack + 8 * rounding) << "the intersection of the faces is larger than the hull";
  EXPECT_GT(volume(hull), 0);
}

ConvexHull checkedHull(const Points& points) {
  const ConvexHull hull = convexHull(points);
  expectHull(hull, points);
  return hull;
}

// Degenerate input.

TEST(ConvexHull, RejectsAnEmptySet) {
  try {
    convexHull({});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kEmptyMesh);
  }
}

TEST(ConvexHull, RejectsNonFiniteCoordinates) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Points points = test_shapes::box(1, 1, 1).vertices;
    points[3].y() = bad;
    try {
      convexHull(points);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kNonFiniteCoordinate);
      EXPECT_NE(std::string(error.what()).find("3"), std::string::npos);
    }
  }
}

TEST(ConvexHull, APointBecomesASmallBody) {
  for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(1, -2, 3), Vector3d(1e6, 1e6, 1e6), Vector3d(1e-30, 0, 0)}) {
    SCOPED_TRACE(p.transpose());
    for (std::size_t copies : {1u, 2u, 50u}) {
      const ConvexHull hull = checkedHull(Points(copies, p));
      EXPECT_GT(hull.thickness, 0);
      EXPECT_LE(hull.thickness, std::max(1e-9, 1e-11 * p.norm()));
      EXPECT_LE(extentOf(hull.vertices), 3 * hull.thickness);
    }
  }
}

TEST(ConvexHull, ALineBecomesAThinRod) {
  RandomPoints random(3);
  for (const Vector3d& direction : {Vector3d(1, 0, 0), Vector3d(0, 0, 1e-3), Vector3d(1, 2, 3), Vector3d(1, 1e-9, -1)}) {
    SCOPED_TRACE(direction.transpose());
    Points points{Vector3d(5, 5, 5), Vector3d(5, 5, 5) + direction};
    for (int i = 0; i < 30; ++i) points.push_back(points[0] + random.number(0, 1) * direction);
    const ConvexHull hull = checkedHull(points);
    EXPECT_GT(hull.thickness, 0);
    EXPECT_LE(hull.thickness, 1e-5 * direction.norm());
    EXPECT_NEAR(extentOf(hull.vertices), direction.norm(), 1e-5 * direction.norm());
  }
}

TEST(ConvexHull, APlaneBecomesAThinPlate) {
  RandomPoints random(4);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const Eigen::Matrix3d turn = i < 4 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random.rotation();
    const double size = std::pow(10.0, random.number(-6, 4)), far = i % 2 ? 0 : 100 * size;
    Points points;
    for (int k = 0; k < 3 + 2 * i; ++k) {
      const double x = i % 3 == 0 ? random.index(4) / 4.0 : random.number(), y = i % 3 == 0 ? random.index(4) / 4.0 : random.number();
      points.push_back(turn * Vector3d(x * size, y * size, far));
    }
    const ConvexHull hull = checkedHull(points);
    EXPECT_GT(hull.thickness, 0);
    EXPECT_LE(hull.thickness, 1e-5 * extentOf(points) + 1e-9 * size);
  }
}

// The frame's second axis lies along three of them, which rounding then puts in any order.
TEST(ConvexHull, AFlatSetKeepsTheCornersOfAnEdgeAcrossItsFrame) {
  RandomPoints random(8);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Eigen::Matrix3d turn = random.rotation();
    Points points;
    for (const Vector3d& p : {Vector3d(5, 5, 0), {0, 0, 0}, {10, 0, 0}, {-1.5, 3, 0}, {-1.5, 5, 0}, {-1.5, 7, 0}})
      points.push_back(turn * p / 10 + Vector3d(0.3, 0.2, 0.1) * (i % 2));
    checkedHull(points);
  }
}

TEST(ConvexHull, NearlyFlatSetsAcrossTheThreshold) {
  RandomPoints random(5);
  for (double height : {1e-3, 1e-4, 1e-5, 3e-6, 1.5e-6, 1.01e-6, 9.9e-7, 5e-7, 1e-7, 1e-9, 1e-12, 1e-15}) {
    for (int i = 0; i < 12; ++i) {
      SCOPED_TRACE(testing::Message() << "height " << height << ", case " << i);
      const Eigen::Matrix3d turn = i % 2 ? random.rotation() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
      Points points;
      for (int k = 0; k < 60; ++k) {
        Vector3d p = random.inCube();
        if (i % 3 == 0) p = Vector3d(random.index(5) / 2.0, random.index(5) / 2.0, random.index(2));
        if (i % 3 == 1) p.z() = p.head<2>().squaredNorm();
        if (i >= 6) p.y() *= 1e-3;
        points.push_back(turn * p.cwiseProduct(Vector3d(1, 1, height)));
      }
      checkedHull(points);
    }
  }
}

TEST(ConvexHull, NeedlesAndRodsAcrossTheThreshold) {
  RandomPoints random(6);
  for (double breadth : {1e-3, 1e-5, 2e-6, 1e-6, 5e-7, 1e-9, 1e-13})
    for (double height : {1e-3, 1e-5, 2e-6, 1e-6, 5e-7, 1e-9, 1e-13}) {
      SCOPED_TRACE(testing::Message() << breadth << " x " << height);
      const Eigen::Matrix3d turn = random.rotation();
      Points points;
      for (int k = 0; k < 40; ++k) points.push_back(turn * random.inCube().cwiseProduct(Vector3d(1, breadth, height)));
      checkedHull(points);
    }
}

// Closed-form answers.

TEST(ConvexHull, ABoxHasSixFaces) {
  const ConvexHull hull = checkedHull(test_shapes::box(1, 2, 3, 5).vertices);
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(hull.faces.size(), 6u);
  EXPECT_EQ(hull.thickness, 0);
  EXPECT_NEAR(volume(hull), 6, 1e-11);
  EXPECT_EQ(boundingBox(hull).max(), Vector3d(1, 2, 3));
}

TEST(ConvexHull, ARotatedPrismHasOneFacePerSide) {
  RandomPoints random(8);
  const Eigen::Matrix3d turn = random.rotation();
  for (int sides : {3, 8, 64, 500}) {
    Points points;
    for (int i = 0; i < sides; ++i)
      for (double z : {0.0, 1.0, 2.0}) {
        const double a = 2 * test_shapes::kPi * i / sides;
        points.push_back(turn * Vector3d(std::cos(a), std::sin(a), z));
      }
    const ConvexHull hull = checkedHull(points);
    EXPECT_EQ(hull.vertices.size(), 2 * static_cast<std::size_t>(sides));
    EXPECT_EQ(hull.faces.size(), static_cast<std::size_t>(sides) + 2);
  }
}

TEST(ConvexHull, AnIcosahedronHasTwentyFaces) {
  const TriangleMesh mesh = test_shapes::sphere(1, 1);
  const ConvexHull hull = checkedHull(mesh.vertices);
  EXPECT_EQ(hull.vertices.size(), 12u);
  EXPECT_EQ(hull.faces.size(), 20u);
  EXPECT_NEAR(volume(hull), signedVolume(mesh), 1e-11);
}

TEST(ConvexHull, ConvexMeshesAreTheirOwnHull) {
  const TriangleMesh mesh = test_shapes::sphere(2, 8);
  const ConvexHull hull = checkedHull(mesh.vertices);
  EXPECT_EQ(hull.vertices.size(), mesh.vertices.size());
  EXPECT_NEAR(volume(hull), signedVolume(mesh), 1e-10);
}

TEST(ConvexHull, DistancesToABox) {
  const ConvexHull hull = convexHull(test_shapes::box(1, 1, 1).vertices);
  EXPECT_EQ(distance(hull, {0.5, 0.5, 0.5}), 0);
  EXPECT_EQ(distance(hull, {1, 1, 1}), 0);
  EXPECT_NEAR(distance(hull, {0.5, 0.5, 3}), 2, 1e-11);
  EXPECT_NEAR(distance(hull, {4, 5, 0.5}), 5, 1e-11);
  EXPECT_NEAR(distance(hull, {-2, -3, -6}), 7, 1e-11);
  EXPECT_NEAR(planeDistance(hull, {0.5, 0.5, 0.75}), -0.25, 1e-11);
  EXPECT_NEAR(planeDistance(hull, {-2, -3, -6}), 6, 1e-11);
}

TEST(ConvexHull, TheSurfaceIsItsTriangles) {
  const TriangleMesh mesh = surface(convexHull(test_shapes::box(1, 2, 3).vertices));
  EXPECT_NEAR(area(mesh), 22, 1e-10);
}

// Random input.

TEST(ConvexHull, HoldsNothingThatIsNotFinite) {
  const ConvexHull hull = convexHull(test_shapes::box(1, 1, 1).vertices);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(nan, nan, nan), {nan, 0.5, 0.5}, {0.5, 0.5, nan}, {infinity, 0.5, 0.5}, {0.5, -infinity, 0}}) {
    EXPECT_FALSE(holds(hull, p)) << p.transpose();
    EXPECT_TRUE(std::isnan(planeDistance(hull, p))) << p.transpose();
    EXPECT_TRUE(std::isnan(distance(hull, p))) << p.transpose();
  }
}

TEST(ConvexHull, NothingLiesInOneWithoutFaces) {
  EXPECT_FALSE(holds(ConvexHull(), {0, 0, 0}));
  EXPECT_EQ(planeDistance(ConvexHull(), {0, 0, 0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(distance(ConvexHull(), {0, 0, 0}), std::numeric_limits<double>::infinity());
}

TEST(ConvexHull, OneThatIsNotWholeIsRefusedByNumber) {
  const ConvexHull whole = convexHull(test_shapes::box(1, 1, 1).vertices);
  EXPECT_NO_THROW(check({whole, ConvexHull(), whole}));
  const auto refusal = [&](const auto& spoil) {
    std::vector<ConvexHull> hulls{whole, whole};
    spoil(hulls[1]);
    try {
      check(hulls);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("hull 1: ", 0), 0u) << error.what();
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  const double nan = std::nan("");
  EXPECT_EQ(refusal([](ConvexHull& hull) { hull.vertices.clear(); }), ErrorCode::kEmptyMesh);
  EXPECT_EQ(refusal([](ConvexHull& hull) { hull.triangles.clear(); }), ErrorCode::kEmptyMesh);
  EXPECT_EQ(refusal([](ConvexHull& hull) { hull.faces.clear(); }), ErrorCode::kEmptyMesh);
  EXPECT_EQ(refusal([&](ConvexHull& hull) { hull.vertices[3].y() = nan; }), ErrorCode::kNonFiniteCoordinate);
  EXPECT_EQ(refusal([&](ConvexHull& hull) { hull.faces[2].offset = nan; }), ErrorCode::kNonFiniteCoordinate);
  EXPECT_EQ(refusal([](ConvexHull& hull) { hull.faces[2].normal *= 2; }), ErrorCode::kBadOption);
  EXPECT_EQ(refusal([](ConvexHull& hull) { hull.triangles[2][1] = 8; }), ErrorCode::kIndexOutOfRange);
  EXPECT_EQ(refusal([](ConvexHull& hull) { hull.triangles[2][1] = -1; }), ErrorCode::kIndexOutOfRange);
}

TEST(ConvexHull, RandomSetsOfAnySizeAnywhere) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const double size = std::pow(10.0, random.number(-9, 6)), far = seed % 3 == 0 ? 1e6 * size : 0;
    const Vector3d place = far * random.onSphere();
    Points points = random.cloud(4 + 3 * seed, size);
    for (Vector3d& p : points) p += place;
    const ConvexHull hull = checkedHull(points);
    EXPECT_EQ(hull.thickness, 0);
  }
}

TEST(ConvexHull, SetsWithManyPointsInOnePlane) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const Eigen::Matrix3d turn = seed % 2 ? random.rotation() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    Points points;
    for (int i = 0; i < 100; ++i) points.push_back(turn * Vector3d(random.index(6), random.index(6), random.index(6)));
    for (int i = 0; i < 20; ++i) points.push_back(points[static_cast<std::size_t>(random.index(points.size()))]);
    checkedHull(points);
  }
}

TEST(ConvexHull, CoplanarUpToNoiseOfAnySize) {
  for (double noise : {1e-16, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6})
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(testing::Message() << "noise " << noise << ", seed " << seed);
      RandomPoints random(seed);
      Points points = test_shapes::box(1, 1, 1, 6).vertices;
      for (Vector3d& p : points) p += random.inCube(noise);
      checkedHull(points);
    }
}

TEST(ConvexHull, AFlatDomeKeepsItsShape) {
  // Normals of neighbouring faces differ by less and less: merging similar ones must not leave the top of the dome open.
  for (double height : {1e-2, 1e-4, 1e-5}) {
    SCOPED_TRACE(height);
    Points points;
    for (int i = -20; i <= 20; ++i)
      for (int j = -20; j <= 20; ++j) {
        const double x = i / 20.0, y = j / 20.0;
        points.push_back({x, y, -height * (x * x + y * y)});
      }
    const ConvexHull hull = checkedHull(points);
    EXPECT_GT(hull.vertices.size(), 1000u);
  }
}

TEST(ConvexHull, DuplicatePointsChangeNothing) {
  RandomPoints random(9);
  Points points = random.cloud(50);
  const double once = volume(convexHull(points));
  points.insert(points.end(), points.begin(), points.begin() + 50);
  EXPECT_NEAR(volume(checkedHull(points)), once, 1e-12);
}

TEST(ConvexHull, SameInputGivesSameBytes) {
  RandomPoints random(10);
  const Points points = random.cloud(400);
  const ConvexHull a = convexHull(points), b = convexHull(points);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(ConvexHull, DistanceAgreesWithBruteForce) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    Points points = random.cloud(30);
    if (seed % 3 == 1)
      for (Vector3d& p : points) p = p.cwiseProduct(Vector3d(1, 1, 1e-5));
    const ConvexHull hull = convexHull(points);
    for (int i = 0; i < 200; ++i) {
      const Vector3d p = i % 2 ? random.inCube(3) : Vector3d(random.on(surface(hull)) + random.inCube(1e-3));
      double least = std::numeric_limits<double>::infinity();
      for (const Triangle& t : hull.triangles) {
        const auto at = [&](std::size_t k) { return hull.vertices[static_cast<std::size_t>(t[k])]; };
        least = std::min(least, (closestPoint(at(0), at(1), at(2), p) - p).norm());
      }
      const double d = distance(hull, p);
      EXPECT_NEAR(d, planeDistance(hull, p) <= 0 ? 0 : least, 1e-12);
      EXPECT_GE(d, planeDistance(hull, p) - 1e-12);
    }
  }
}

}  // namespace
}  // namespace collision_hulls
