// Also tests src/primitives/enclosing_primitive.cpp.
#include "collision_hulls/primitives/primitive.h"

#include <gtest/gtest.h>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Kind = PrimitiveKind;
using test_shapes::RandomPoints;

const Eigen::Isometry3d kAnyPlace =
    Eigen::Translation3d(0.3, -0.7, 1.1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()) * Eigen::Isometry3d::Identity();

std::vector<Primitive> oneOfEach() {
  return {{Kind::kBox, {1, 2, 0.5}, kAnyPlace},
          {Kind::kSphere, {0.8, 0, 0}, kAnyPlace},
          {Kind::kCylinder, {0.4, 1.5, 0}, kAnyPlace},
          {Kind::kCapsule, {0.4, 1.5, 0}, kAnyPlace}};
}

/// Whether a point lies in a primitive, from its definition.
bool isIn(const Primitive& primitive, const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = primitive.pose.inverse() * p, size = primitive.size;
  const double half = size.y() / 2;
  switch (primitive.kind) {
    case Kind::kBox: return (2 * q.cwiseAbs() - size).maxCoeff() <= 0;
    case Kind::kSphere: return q.norm() <= size.x();
    case Kind::kCylinder: return q.head<2>().norm() <= size.x() && std::abs(q.z()) <= half;
    case Kind::kCapsule:
      return std::min({(q - half * Eigen::Vector3d::UnitZ()).norm(), (q + half * Eigen::Vector3d::UnitZ()).norm(),
                       std::abs(q.z()) <= half ? q.head<2>().norm() : size.x() + 1}) <= size.x();
  }
  return false;
}

TEST(Primitive, KindsHaveNames) {
  for (const Kind kind : allPrimitiveKinds()) EXPECT_EQ(primitiveKindNamed(name(kind)), kind);
  EXPECT_FALSE(primitiveKindNamed("cone"));
}

TEST(Primitive, DistanceIsZeroJustInside) {
  RandomPoints random(1);
  for (const Primitive& primitive : oneOfEach())
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d p = kAnyPlace * random.inCube(1.5), nearest = nearestPoint(primitive, p);
      EXPECT_EQ(distance(primitive, p) == 0, isIn(primitive, p)) << name(primitive.kind);
      if (nearest == p) continue;
      EXPECT_TRUE(isIn(primitive, nearest + 1e-9 * (kAnyPlace.translation() - nearest)));
      // Nothing lies beyond the plane through the nearest point across the way to it.
      EXPECT_NEAR(support(primitive, (p - nearest).normalized()), (p - nearest).normalized().dot(nearest), 1e-9);
    }
}

TEST(Primitive, SupportIsReachedAndNotExceeded) {
  RandomPoints random(2);
  for (const Primitive& primitive : oneOfEach())
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector3d direction = random.onSphere(), far = kAnyPlace.translation() + 1e6 * direction;
      EXPECT_NEAR(support(primitive, direction), direction.dot(nearestPoint(primitive, far)), 1e-5) << name(primitive.kind);
      const Eigen::Vector3d p = kAnyPlace * random.inCube(1.2);
      if (isIn(primitive, p)) {
        EXPECT_LE(direction.dot(p), support(primitive, direction));
      }
    }
}

TEST(Primitive, Volume) {
  RandomPoints random(3);
  for (const Primitive& primitive : oneOfEach()) {
    const int tries = 200000;
    int in = 0;
    for (int i = 0; i < tries; ++i) in += isIn(primitive, kAnyPlace * random.inCube(1.2));
    EXPECT_NEAR(volume(primitive), std::pow(2.4, 3) * in / tries, 0.02 * volume(primitive)) << name(primitive.kind);
  }
}

TEST(HullAround, ContainsThePrimitiveAndExceedsItBarely) {
  RandomPoints random(4);
  for (const Primitive& primitive : oneOfEach())
    for (const double excess : {0.1, 0.01, 0.001}) {
      const ConvexHull around = hullAround(primitive, excess);
      for (int i = 0; i < 2000; ++i) EXPECT_LE(planeDistance(around, nearestPoint(primitive, kAnyPlace * random.inCube(3))), 1e-12);
      for (const Eigen::Vector3d& v : around.vertices) EXPECT_LE(distance(primitive, v), 1.01 * excess) << name(primitive.kind);
    }
}

// Far away, what is built cuts nearly every small box and cylinder, and has to grow.
TEST(HullAround, NoFaceCutsThePrimitiveNotEvenByRounding) {
  RandomPoints random(6);
  for (const double scale : {1.0, 1e-3, 1e-6})
    for (const double far : {10.0, 1e3, 1e6})
      for (Primitive primitive : oneOfEach()) {
        primitive.size *= scale;
        for (int i = 0; i < 10; ++i) {
          primitive.pose = Eigen::Translation3d(random.inCube(far)) * Eigen::Isometry3d(random.rotation());
          for (const HalfSpace& face : hullAround(primitive, 0.05 * scale).faces)
            ASSERT_LE(support(primitive, face.normal), face.offset) << name(primitive.kind) << " " << scale << " " << far;
        }
      }
}

TEST(EnclosingPrimitive, EnclosesThePointsAtAnyScale) {
  RandomPoints random(5);
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const Kind kind : allPrimitiveKinds()) {
      std::vector<Eigen::Vector3d> points = random.cloud(40, scale);
      for (Eigen::Vector3d& p : points) p += scale * Eigen::Vector3d(3, -2, 1);
      const Primitive primitive = enclosingPrimitive(kind, convexHull(points));
      for (const Eigen::Vector3d& p : points) EXPECT_TRUE(isIn(primitive, p)) << name(kind);
    }
}

TEST(EnclosingPrimitive, OfItsOwnShapeIsThatShape) {
  for (const Primitive& primitive : oneOfEach()) {
    const Primitive found = enclosingPrimitive(primitive.kind, hullAround(primitive, 0.001));
    EXPECT_NEAR(volume(found), volume(primitive), 0.02 * volume(primitive)) << name(primitive.kind);
    EXPECT_LT((found.pose.translation() - primitive.pose.translation()).norm(), 0.01) << name(primitive.kind);
  }
}

// Half a turn to an axis that is nearly that of -z has to be as precise as any other.
TEST(EnclosingPrimitive, OfBarsNearlyAlongZ) {
  for (const double tilt : {1e-8, 1e-7, 1e-6, 2e-6, 1e-5})
    for (int way = 0; way < 24; ++way) {
      const Eigen::AngleAxisd turn(tilt, Eigen::Vector3d(std::cos(way), std::sin(way), 0));
      std::vector<Eigen::Vector3d> points;
      for (int k = 0; k < 16; ++k)
        for (const double z : {-0.3, 0.3})
          points.push_back(turn * Eigen::Vector3d(std::cos(k * M_PI / 8 + way), std::sin(k * M_PI / 8 + way), z));
      EXPECT_NO_THROW(enclosingPrimitive(Kind::kCylinder, convexHull(points))) << tilt << " " << way;
    }
}

TEST(EnclosingPrimitive, NoneEnclosesAHullWithoutVertices) {
  for (const Kind kind : allPrimitiveKinds()) {
    try {
      enclosingPrimitive(kind, ConvexHull());
      ADD_FAILURE() << name(kind);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kEmptyMesh);
    }
  }
}

TEST(EnclosingPrimitive, OfDegeneratePoints) {
  const std::vector<std::vector<Eigen::Vector3d>> sets{
      {{3, -2, 1}}, {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}};
  for (const std::vector<Eigen::Vector3d>& points : sets)
    for (const Kind kind : allPrimitiveKinds()) {
      const Primitive primitive = enclosingPrimitive(kind, convexHull(points));
      for (const Eigen::Vector3d& p : points) EXPECT_TRUE(isIn(primitive, p)) << name(kind);
    }
}

}  // namespace
}  // namespace collision_hulls
