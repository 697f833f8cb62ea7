#include "check/validate_exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

ConvexHull cube(const Vector3d& centre, double side) {
  return convexHull(test_shapes::moved(test_shapes::box(side, side, side), centre - Vector3d::Constant(side / 2)).vertices);
}

TEST(PointDistance, OnInsideAndAround) {
  const ConvexHull hull = convexHull(test_shapes::torus(1, 0.3, 24, 24).vertices);  // flat faces with many corners on top and below
  for (const Vector3d& v : hull.vertices) EXPECT_LT(pointDistance(hull, v), 1e-12);
  EXPECT_EQ(pointDistance(hull, Vector3d(0.2, 0.1, 0)), 0);
  EXPECT_NEAR(pointDistance(hull, Vector3d(0.4, 0.3, 0.8)), 0.5, 1e-12);
}

TEST(NearestPoint, OnInsideAndAround) {
  const ConvexHull body = convexHull(test_shapes::box(1, 1, 1).vertices);
  for (const auto& [p, nearest] : std::vector<std::pair<Vector3d, Vector3d>>{
           {{0.5, 0.4, 0.3}, {0.5, 0.4, 0.3}}, {{0.5, 0.4, 1.3}, {0.5, 0.4, 1}}, {{-1, 2, 0.3}, {0, 1, 0.3}}, {{2, 2, 2}, {1, 1, 1}}})
    EXPECT_LT((nearestPoint(body, p) - nearest).norm(), 1e-12) << p.transpose();
}

TEST(CommonPoints, AreTheCornersOfTheOverlap) {
  const ConvexHull body = convexHull(test_shapes::box(1, 1, 1).vertices);
  const auto with = [&](const Vector3d& offset) {
    return commonPoints(body, convexHull(test_shapes::moved(test_shapes::box(1, 1, 1), offset).vertices));
  };
  EXPECT_TRUE(with({1.5, 0, 0}).empty());
  const std::vector<Vector3d> points = with({0.6, 0.7, 0.8});
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) box.extend(p);
  EXPECT_LT((box.min() - Vector3d(0.6, 0.7, 0.8)).norm(), 1e-9);
  EXPECT_LT((box.max() - Vector3d(1, 1, 1)).norm(), 1e-9);
  EXPECT_TRUE(box.contains(points.back()));
  for (const Vector3d& corner : {Vector3d(0.6, 0.7, 0.8), Vector3d(1, 1, 1)}) {  // one of each body, inside the other
    const auto is_it = [&](const Vector3d& p) { return (p - corner).norm() < 1e-9; };
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), is_it)) << corner.transpose();
  }
}

TEST(DistanceToBody, ContactContainmentAndLimit) {
  const TriangleMesh sheet = test_shapes::sheet();
  EXPECT_NEAR(distanceToBody(sheet, cube({0.5, 0.5, 0.75}, 0.5)), 0.5, 1e-12);
  EXPECT_EQ(distanceToBody(sheet, cube({0.5, 0.5, 0.2}, 0.5)), 0) << "pierced, with no corner of the sheet in the cube";
  EXPECT_EQ(distanceToBody(sheet, cube({0, 0, 0}, 5)), 0) << "the cube contains the sheet";
  EXPECT_EQ(distanceToBody(sheet, cube({0.5, 0.5, 0.75}, 0.5), 0.125), 0.125);
  EXPECT_TRUE(std::isinf(distanceToBody(TriangleMesh{}, cube({0, 0, 0}, 1))));
}

TEST(DistanceToBody, ACornerOfATriangleOverAFace) {
  const TriangleMesh spike{{{0.1, -0.2, 0.75}, {0.1, -0.2, 3}, {0.2, -0.2, 3}}, {{0, 1, 2}}};
  EXPECT_NEAR(distanceToBody(spike, cube({0, 0, 0}, 1)), 0.25, 1e-12);
}

TEST(DistanceToBody, TriangleWithoutArea) {
  const TriangleMesh point{{Vector3d(2, 0, 0)}, {{0, 0, 0}}};
  EXPECT_NEAR(distanceToBody(point, cube({0, 0, 0}, 1)), 1.5, 1e-12);
  const TriangleMesh line{{Vector3d(1, -3, 0), Vector3d(1, 3, 0), Vector3d(1, 1, 0)}, {{0, 1, 2}}};
  EXPECT_NEAR(distanceToBody(line, cube({0, 0, 0}, 1)), 0.5, 1e-12);
}

TEST(BodyDistance, FacesEdgesAndCorners) {
  const ConvexHull unit = cube({0, 0, 0}, 1);
  EXPECT_NEAR(bodyDistance(unit, cube({2, 0.1, 0}, 1)), 1, 1e-12);
  EXPECT_NEAR(bodyDistance(unit, cube({2, 2, 2}, 1)), std::sqrt(3.0), 1e-12);
  Eigen::Isometry3d turned(Eigen::AngleAxisd(test_shapes::kPi / 4, Vector3d::UnitZ()));
  turned = Eigen::AngleAxisd(test_shapes::kPi / 2, Vector3d::UnitX()) * turned;  // one of its edges runs along y and points to x
  turned = Eigen::Translation3d(0.75 + std::sqrt(0.5), 0, 0) * turned;
  EXPECT_NEAR(bodyDistance(unit, transformed(unit, turned)), 0.25, 1e-12);
}

TEST(BodyDistance, ContainedEitherWay) {
  EXPECT_EQ(bodyDistance(cube({0, 0, 0}, 1), cube({0.1, 0, 0}, 0.2)), 0);
  EXPECT_EQ(bodyDistance(cube({0.1, 0, 0}, 0.2), cube({0, 0, 0}, 1)), 0);
  EXPECT_EQ(bodyDistance(cube({0, 0, 0}, 1), cube({0.9, 0, 0}, 1)), 0);
}

TEST(Proved, OnlyByPointsOfTheBodiesAndSeparatingPlanes) {
  const ConvexHull first = cube({0, 0, 0}, 1), second = cube({2, 0, 0}, 1);
  FclAnswer answer;
  answer.distance = 1;
  answer.on_first = Vector3d(0.5, 0.1, 0.2);
  answer.on_second = Vector3d(1.5, 0.1, 0.2);
  EXPECT_TRUE(proved(answer, first, second, 1e-9));

  for (const double aside : {0.1, 0.02, 1e-4}) {
    FclAnswer too_far = answer;  // points of the bodies, but not the nearest ones
    too_far.on_second = Vector3d(1.5, 0.1 + aside, 0.2);
    too_far.distance = (too_far.on_second - too_far.on_first).norm();
    EXPECT_FALSE(proved(too_far, first, second, 1e-9)) << aside;
  }

  FclAnswer too_near = answer;  // a point outside its body
  too_near.on_second = Vector3d(1.25, 0.1, 0.2);
  too_near.distance = 0.75;
  EXPECT_FALSE(proved(too_near, first, second, 1e-9));

  too_near = answer;  // the same of the first body
  too_near.on_first = Vector3d(0.75, 0.1, 0.2);
  too_near.distance = 0.75;
  EXPECT_FALSE(proved(too_near, first, second, 1e-9));

  for (const double share : {0.9, 1.1}) {  // another distance than that of the points
    FclAnswer other = answer;
    other.distance *= share;
    EXPECT_FALSE(proved(other, first, second, 1e-9)) << share;
  }

  for (const FclAnswer::Status status : {FclAnswer::Status::kException, FclAnswer::Status::kNan}) {
    FclAnswer failed = answer;
    failed.status = status;
    EXPECT_FALSE(proved(failed, first, second, 1e-9));
  }

  FclAnswer nan = answer;
  nan.distance = std::nan("");
  EXPECT_FALSE(proved(nan, first, second, 1e-9));
  nan = answer;
  nan.on_first.x() = std::nan("");
  EXPECT_FALSE(proved(nan, first, second, 1e-9));
}

}  // namespace
}  // namespace collision_hulls
