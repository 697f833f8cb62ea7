#include "collision_hulls/decompose/reduce_vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "collision_hulls/error.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Points = std::vector<Eigen::Vector3d>;

void expectHolds(const ConvexHull& outer, const ConvexHull& inner) {
  for (const Eigen::Vector3d& v : inner.vertices) EXPECT_LE(planeDistance(outer, v), 0);
}

Points ellipsoid(std::size_t count, const Eigen::Vector3d& radii, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(radii.cwiseProduct(Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized()));
  return points;
}

Points cylinder(int segments, double radius, double height) {
  Points points;
  for (int i = 0; i < segments; ++i) {
    const double a = 2 * test_shapes::kPi * i / segments;
    for (double z : {0.0, height}) points.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
  }
  return points;
}

TEST(ReduceVertices, KeepsHullsWithinTheCap) {
  const ConvexHull cube = convexHull(test_shapes::box(1, 1, 1).vertices);
  const ConvexHull reduced = reduceVertices(cube, 8);
  EXPECT_EQ(reduced.vertices.size(), 8u);
  EXPECT_EQ(reduced.vertices, cube.vertices);
  EXPECT_EQ(addedDistance(reduced, cube), 0);
}

TEST(ReduceVertices, RejectsACapBelowABox) {
  try {
    reduceVertices(convexHull(test_shapes::box(1, 1, 1).vertices), 7);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    EXPECT_NE(std::string(error.what()).find("at least 8"), std::string::npos);
  }
}

TEST(ReduceVertices, EnclosesARoundHullClosely) {
  const ConvexHull sphere = convexHull(test_shapes::sphere(1, 14).vertices);
  ASSERT_EQ(sphere.vertices.size(), 1962u);
  const ConvexHull reduced = reduceVertices(sphere, 64);
  EXPECT_LE(reduced.vertices.size(), 64u);
  expectHolds(reduced, sphere);
  EXPECT_GT(addedDistance(reduced, sphere), 0.03);
  EXPECT_LT(addedDistance(reduced, sphere), 0.07) << "three attempts to space the vertices evenly leave 0.08";
}

TEST(ReduceVertices, ACylinderStaysACylinder) {
  const ConvexHull hull = convexHull(cylinder(128, 1, 2));
  const ConvexHull reduced = reduceVertices(hull, 64);
  expectHolds(reduced, hull);
  EXPECT_LT(addedDistance(reduced, hull), 0.03);
  EXPECT_LT(volume(reduced), 1.02 * volume(hull));
}

TEST(ReduceVertices, AddedDistanceIsThatOfTheFurthestVertex) {
  const ConvexHull hull = convexHull(cylinder(128, 1, 2));
  const ConvexHull reduced = reduceVertices(hull, 16);
  double most = 0;
  for (const Eigen::Vector3d& v : reduced.vertices) most = std::max(most, distance(hull, v));
  EXPECT_DOUBLE_EQ(addedDistance(reduced, hull), most);
}

TEST(ReduceVertices, AFlatHullStaysFlat) {
  Points disc;
  for (const Eigen::Vector3d& p : cylinder(200, 1, 0)) disc.push_back(p);
  const ConvexHull hull = convexHull(disc);
  ASSERT_GT(hull.thickness, 0);
  const ConvexHull reduced = reduceVertices(hull, 64);
  expectHolds(reduced, hull);
  EXPECT_LE(reduced.vertices.size(), 64u);
  EXPECT_LT(addedDistance(reduced, hull), 0.03);
  EXPECT_LT(boundingBox(reduced).sizes().z(), 1e-4);
  EXPECT_GE(reduced.thickness, hull.thickness);
}

TEST(ReduceVertices, ContainsHullsOfAnyShapeAndSizeAnywhere) {
  const unsigned seed = 3;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-3, 0);
  for (int repeat = 0; repeat < 30; ++repeat) {
    const double size = std::pow(10, 2 * exponent(random));
    const Eigen::Vector3d radii(size, size * std::pow(10, exponent(random)), size * std::pow(10, exponent(random)));
    Points points = ellipsoid(150, radii, random);
    for (Eigen::Vector3d& p : points) p += Eigen::Vector3d(1, -2, 3) * (repeat % 3);
    const ConvexHull hull = convexHull(points);
    const int cap = repeat % 2 ? 32 : 8;
    const ConvexHull reduced = reduceVertices(hull, cap);
    SCOPED_TRACE("repeat " + std::to_string(repeat));
    EXPECT_LE(reduced.vertices.size(), static_cast<std::size_t>(cap));
    expectHolds(reduced, hull);
    EXPECT_LT(addedDistance(reduced, hull), (cap == 8 ? 2.0 : 0.4) * size);
  }
}

TEST(ReduceVertices, ACapOfZeroIsNoCap) {
  std::mt19937 random(4);
  const ConvexHull hull = convexHull(ellipsoid(100, {1, 1, 1}, random));
  const int vertices = static_cast<int>(hull.vertices.size());
  EXPECT_FALSE(exceedsCap(hull, 0));
  EXPECT_FALSE(exceedsCap(hull, vertices));
  EXPECT_TRUE(exceedsCap(hull, vertices - 1));
  EXPECT_EQ(capped(hull, 0).vertices, hull.vertices);
  EXPECT_EQ(capped(hull, vertices).vertices, hull.vertices);
  EXPECT_LE(capped(hull, 16).vertices.size(), 16U);
}

TEST(ReduceVertices, SameInputGivesSameResult) {
  std::mt19937 random(9);
  const ConvexHull hull = convexHull(ellipsoid(300, {3, 2, 1}, random));
  EXPECT_EQ(reduceVertices(hull, 40).vertices, reduceVertices(hull, 40).vertices);
}

}  // namespace
}  // namespace collision_hulls
