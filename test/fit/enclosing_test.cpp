#include "fit/enclosing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "random_points.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;
using Points = std::vector<Eigen::Vector3d>;
using test_shapes::RandomPoints;

constexpr Kind kKinds[] = {Kind::kBox, Kind::kSphere, Kind::kCylinder};
constexpr double kLarger = 1e-6;  // of the size: allows for rounding and the margin against it

const Eigen::Isometry3d kAnyPlace =
    Eigen::Translation3d(0.3, -0.7, 1.1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()) * Eigen::Isometry3d::Identity();

Points moved(Points points) {
  for (Eigen::Vector3d& p : points) p = kAnyPlace * p;
  return points;
}

void expectHolds(const GeometryElement& primitive, const Points& points) {
  for (const Eigen::Vector3d& p : points) EXPECT_EQ(nearestPoint(primitive, p), p) << static_cast<int>(primitive.kind);
}

/// The primitive after it was written to a robot description and read back.
GeometryElement readBack(const GeometryElement& primitive) {
  RobotDescription robot = parseRobotDescription("<robot name='r'><link name='a'/></robot>");
  LinkCollisions link;
  link.elements.push_back({"", primitive});
  return parseRobotDescription(rewriteCollisions(robot, {{"a", link}})).links[0].collisions[0];
}

Points ring(double radius, double z, int count) {
  Points points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(radius * std::cos(2 * EIGEN_PI * i / count), radius * std::sin(2 * EIGEN_PI * i / count), z);
  return points;
}

TEST(EnclosingPrimitive, OnePoint) {
  for (const Points& points : {Points{{0, 0, 0}}, Points{{3, -2, 1}}}) {
    for (const Kind kind : kKinds) {
      const GeometryElement primitive = enclosingPrimitive(kind, convexHull(points));
      expectHolds(primitive, points);
      EXPECT_GT(primitive.size.x(), 0);
      EXPECT_LT(primitive.size.maxCoeff(), 1e-4);
    }
  }
}

TEST(EnclosingPrimitive, PointsOnALine) {
  const Points points = moved({{0, 0, 0}, {0, 0, 0.5}, {0, 0, 2}});
  const ConvexHull hull = convexHull(points);
  for (const Kind kind : kKinds) expectHolds(enclosingPrimitive(kind, hull), points);
  EXPECT_NEAR(enclosingPrimitive(Kind::kSphere, hull).size.x(), 1, 1e-5);
  EXPECT_NEAR(enclosingPrimitive(Kind::kCylinder, hull).size.y(), 2, 1e-5);
  EXPECT_NEAR(enclosingPrimitive(Kind::kBox, hull).size.maxCoeff(), 2, 1e-5);
}

TEST(EnclosingPrimitive, FlatPoints) {
  const Points points = moved({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.4, 0}});
  const ConvexHull hull = convexHull(points);
  for (const Kind kind : kKinds) expectHolds(enclosingPrimitive(kind, hull), points);
  EXPECT_NEAR(enclosingPrimitive(Kind::kSphere, hull).size.x(), std::sqrt(0.5), 1e-5);
  EXPECT_LT(enclosingPrimitive(Kind::kBox, hull).size.minCoeff(), 1e-4);
  EXPECT_LT(volume(enclosingPrimitive(Kind::kCylinder, hull)), 1e-3);
}

TEST(EnclosingPrimitive, PointsOnASphere) {
  RandomPoints random(1);
  Points points;
  for (int i = 0; i < 200; ++i) points.push_back(0.25 * random.onSphere());
  const GeometryElement sphere = enclosingPrimitive(Kind::kSphere, convexHull(moved(points)));
  EXPECT_NEAR(sphere.size.x(), 0.25, 0.25 * kLarger * 10);
  EXPECT_TRUE(sphere.origin.translation().isApprox(kAnyPlace.translation(), 1e-5));
}

TEST(EnclosingPrimitive, SphereAboutATetrahedronAndAnObtuseTriangle) {
  const Points corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_NEAR(enclosingPrimitive(Kind::kSphere, convexHull(corners)).size.x(), std::sqrt(3.0), kLarger * 10);
  // The longest side of the triangle is the diameter.
  EXPECT_NEAR(enclosingPrimitive(Kind::kSphere, convexHull({{0, 0, 0}, {2, 0, 0}, {0.7, 0.1, 0}})).size.x(), 1, 1e-5);
}

TEST(EnclosingPrimitive, PointsOfABox) {
  Points points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? 0.3 : 0, i & 2 ? 0.2 : 0, i & 4 ? 0.1 : 0);
  const GeometryElement box = enclosingPrimitive(Kind::kBox, convexHull(moved(points)));
  EXPECT_NEAR(volume(box), 0.006, 0.006 * kLarger * 100);
}

TEST(EnclosingPrimitive, PointsOfACylinder) {
  for (const double length : {0.05, 0.2, 2.0}) {
    Points points = ring(0.1, 0, 24);
    const Points top = ring(0.1, length, 24);
    points.insert(points.end(), top.begin(), top.end());
    const GeometryElement cylinder = enclosingPrimitive(Kind::kCylinder, convexHull(moved(points)));
    EXPECT_NEAR(cylinder.size.x(), 0.1, 1e-5) << length;
    EXPECT_NEAR(cylinder.size.y(), length, 1e-5) << length;
    EXPECT_NEAR(std::abs(cylinder.origin.linear().col(2).dot(kAnyPlace.linear().col(2))), 1, 1e-9) << length;
  }
}

TEST(EnclosingPrimitive, FindsTheAxisOfACapsule) {
  // None of its edges and none of its principal axes runs exactly along its axis.
  RandomPoints random(2);
  Points points;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3d direction = random.onSphere();
    points.push_back(0.1 * direction + Eigen::Vector3d(0, 0, direction.z() > 0 ? 0.5 : 0));
  }
  const GeometryElement cylinder = enclosingPrimitive(Kind::kCylinder, convexHull(moved(points)));
  EXPECT_LT(volume(cylinder), EIGEN_PI * 0.01 * 0.7 * 1.02);
  EXPECT_GT(std::abs(cylinder.origin.linear().col(2).dot(kAnyPlace.linear().col(2))), 0.999);
}

TEST(EnclosingPrimitive, EnclosesRandomPointsAfterWritingAndReading) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomPoints random(seed);
    const double scale = std::pow(10, random.number(-3, 3));
    const Eigen::Vector3d away = random.inCube(100 * scale);
    Points points = random.cloud(4 + 2 * seed, scale);
    for (Eigen::Vector3d& p : points) p = away + p.cwiseProduct(Eigen::Vector3d(1, 0.3, 0.1));
    const ConvexHull hull = convexHull(points);
    for (const Kind kind : kKinds) {
      const GeometryElement primitive = enclosingPrimitive(kind, hull);
      expectHolds(primitive, hull.vertices);
      expectHolds(readBack(primitive), hull.vertices);
      EXPECT_GE(volume(primitive), volume(hull));
      // The polyhedron around it is hardly larger.
      const ConvexHull about = hullAbout(primitive);
      EXPECT_GE(volume(about), volume(primitive) * (1 - 1e-9));
      EXPECT_LE(volume(about), volume(primitive) * 1.02);
      for (const Eigen::Vector3d& v : hull.vertices) EXPECT_LE(planeDistance(about, v), 0);
    }
  }
}

TEST(EnclosingPrimitive, SphereIsTheSmallest) {
  // The points on the border surround the centre, so a smaller sphere would miss one of them.
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Points points = RandomPoints(seed).cloud(30);
    const GeometryElement sphere = enclosingPrimitive(Kind::kSphere, convexHull(points));
    Points border;
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3d out = p - sphere.origin.translation();
      if (out.norm() > sphere.size.x() * (1 - 1e-5)) border.push_back(out.normalized());
    }
    ASSERT_GE(border.size(), 2u) << seed;
    // The centre lies in the hull of the border's points: they are not all on one side of it.
    EXPECT_LE(distance(convexHull(border), Eigen::Vector3d::Zero()), 1e-4) << seed;
  }
}

TEST(NearestPoint, OfEachKind) {
  GeometryElement primitive;
  primitive.origin = kAnyPlace;
  const auto nearest = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return kAnyPlace.inverse() * nearestPoint(primitive, kAnyPlace * p);
  };
  primitive.kind = Kind::kBox;
  primitive.size = {2, 4, 6};
  EXPECT_TRUE(nearest({3, 1, -5}).isApprox(Eigen::Vector3d(1, 1, -3)));
  primitive.kind = Kind::kSphere;
  EXPECT_TRUE(nearest({0, 5, 0}).isApprox(Eigen::Vector3d(0, 2, 0)));
  primitive.kind = Kind::kCylinder;
  EXPECT_TRUE(nearest({0, 5, 1}).isApprox(Eigen::Vector3d(0, 2, 1)));
  EXPECT_TRUE(nearest({3, 0, 9}).isApprox(Eigen::Vector3d(2, 0, 2)));
  EXPECT_TRUE(nearest({0.5, 0.5, 0.5}).isApprox(Eigen::Vector3d(0.5, 0.5, 0.5)));
}

}  // namespace
}  // namespace collision_hulls
