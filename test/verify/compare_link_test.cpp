// Bounds on cover and protrusion of links whose difference is known.
#include "verify/compare_link.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solids.h"
#include "verify/round_shapes.h"
#include "verify_shapes.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;
using namespace test_shapes;

/// Of a box within the original, which protrudes by nothing itself.
TEST(LinkPair, TheProtrusionCountsHowFarTheOriginalsVerticesWereMoved) {
  LinkBodies original, result;
  original.meshes.push_back({withLooseTop(box(1, 1, 1), kHigher), {}});
  original.resolution = 2e-6;
  result.primitives.push_back(boxElement({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}));
  LinkVerification row;
  row.diagonal = std::sqrt(3.0);
  LinkPair(original, result).measure(row);
  EXPECT_GE(row.protrusion.bound, kHigher + original.resolution);
  EXPECT_LE(row.protrusion.bound, kHigher + original.resolution + 2e-7);
}

/// A sphere and a cylinder, and beside their middle a result that is hardly more than a point. What is furthest from it lies opposite,
/// where the polyhedra in them have no vertex.
TEST(LinkPair, ARoundOriginalReachesBeyondThePolyhedronInIt) {
  test_shapes::RandomPoints random(7);
  for (int i = 0; i < 12; ++i) {
    const bool is_sphere = i % 2 == 0;
    const double angle = random.number(0, 6);
    const Eigen::Vector3d aside = is_sphere ? random.onSphere() : Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
    LinkBodies original, result;
    original.primitives.push_back(roundElement(is_sphere ? Kind::kSphere : Kind::kCylinder, 0.2, 0.2));
    result.primitives.push_back(boxElement(Eigen::Vector3d::Constant(1e-6), original.primitives[0].origin * (0.15 * aside)));
    LinkVerification row;
    row.diagonal = 0.6;
    LinkPair(original, result).measure(row);
    const double furthest = is_sphere ? 0.35 : std::hypot(0.35, 0.1);
    EXPECT_GE(row.uncovered.bound, furthest - 1e-6) << i;
    EXPECT_LE(row.uncovered.bound, furthest + 0.006 * 0.2 + 0.01 * furthest) << i;
    EXPECT_LE(row.uncovered.found, furthest) << i;
  }
}

/// A can that is tilted by a little, alone and beside a box that lies in one of the other side.
TEST(LinkPair, BodiesNearlyAlikeAreApartByTheirDifference) {
  constexpr double kTilt = 4e-6;
  for (const bool is_alone : {true, false}) {
    LinkBodies original, result;
    original.primitives.push_back(roundElement(Kind::kCylinder, 0.01, 1));
    result.primitives = original.primitives;
    result.primitives[0].origin.rotate(Eigen::AngleAxisd(kTilt, Eigen::Vector3d::UnitX()));
    if (!is_alone) {
      for (const double place : {3.0, 5.0}) {
        original.primitives.push_back(boxElement(Eigen::Vector3d::Constant(place < 4 ? 0.1 : 0.2), {place, 0, 0}));
        result.primitives.push_back(boxElement(Eigen::Vector3d::Constant(place < 4 ? 0.2 : 0.1), {place, 0, 0}));
      }
      original.primitives.push_back(boxElement(Eigen::Vector3d::Constant(0.2), {3, 0, 0}));
      result.primitives.push_back(boxElement(Eigen::Vector3d::Constant(0.2), {5, 0, 0}));
    }
    LinkVerification row;
    row.diagonal = 1;
    LinkPair(original, result).measure(row);
    for (const Largest* largest : {&row.uncovered, &row.protrusion}) {
      EXPECT_GE(largest->bound, kTilt / 2) << is_alone;
      EXPECT_LE(largest->bound, 1.1 * kTilt / 2) << is_alone;
      EXPECT_EQ(largest->found, 0) << is_alone;
    }
  }
}

/// A cube of 0.2 m, turned, with a body in its middle: the body's points that are furthest from it lie in front of the middles of its
/// faces, in no direction that the search knows.
TEST(LinkPair, ARoundBodyProtrudesByItsWholeRadius) {
  test_shapes::RandomPoints random(8);
  for (int i = 0; i < 12; ++i) {
    GeometryElement body;
    body.kind = i % 2 ? Kind::kSphere : Kind::kCylinder;
    body.size = {0.17, 0.15, 0};
    const double turn = random.number(0, 1.5);
    LinkBodies original, result;
    original.primitives.push_back(boxElement({0.2, 0.2, 0.2}, {0, 0, 0}));
    original.primitives[0].origin.linear() =
        i % 2 ? random.rotation() : Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    result.primitives.push_back(body);
    LinkVerification row;
    row.diagonal = 0.2 * std::sqrt(3.0);
    LinkPair(original, result).measure(row);
    EXPECT_GE(row.protrusion.bound, 0.07 - 1e-12) << i;
    EXPECT_LE(row.protrusion.bound, 0.0725) << i;
    EXPECT_LE(row.protrusion.found, 0.07 + 1e-12) << i;
  }
}

/// A ball, and a result beside it in a direction in which the polyhedron in the ball has no vertex: that is further away than the ball.
TEST(LinkPair, WhatIsFoundBesideARoundOriginalIsNoFurtherThanFromTheOriginal) {
  test_shapes::RandomPoints random(10);
  for (int i = 0; i < 12; ++i) {
    LinkBodies original, result;
    original.primitives.push_back(roundElement(Kind::kSphere, 0.2, 0));
    const Eigen::Vector3d place = original.primitives[0].origin * (0.3 * random.onSphere());
    const double radius = i % 3 == 0 ? 0.05 : 0;
    GeometryElement ball = roundElement(Kind::kSphere, radius, 0);
    ball.origin = Eigen::Translation3d(place);
    const TriangleMesh bracket = moved(lBracket(1e-9, 1e-10, 1e-9), place);
    if (i % 3 == 2)
      result.meshes.push_back({bracket, {{}, bracket, 1}});
    else
      result.primitives.push_back(radius > 0 ? ball : boxElement(Eigen::Vector3d::Constant(1e-9), place));
    LinkVerification row;
    row.diagonal = 0.2 * std::sqrt(12.0);
    LinkPair(original, result).measure(row);
    EXPECT_LE(row.protrusion.found, 0.1 + radius + 1e-8) << i;
    EXPECT_GE(row.protrusion.bound, 0.1 + radius - 1e-8) << i;
  }
}

/// The polyhedron in a round original is furthest from it in the middle of its lowest face, and a result far behind that sees all of the
/// difference.
TEST(LinkPair, AllOfTheErrorOfThePolyhedronInARoundOriginalCounts) {
  constexpr double kRadius = 0.2, kLength = 0.6, kAway = 100;
  for (const Kind kind : {Kind::kSphere, Kind::kCylinder}) {
    GeometryElement shape = roundElement(kind, kRadius, kLength);
    shape.origin = Eigen::Isometry3d::Identity();
    Eigen::Vector3d lowest = Eigen::Vector3d::Zero();
    double least = kRadius;
    for (const HalfSpace& face : inscribed(shape).hull.faces)
      if (face.offset < least) least = face.offset, lowest = face.normal;
    LinkBodies original, result;
    original.primitives.push_back(shape);
    result.primitives.push_back(boxElement(Eigen::Vector3d::Constant(1e-9), -kAway * lowest));
    LinkVerification row;
    row.diagonal = 1;
    LinkPair(original, result).measure(row);
    const double furthest = kind == Kind::kSphere ? kAway + kRadius : std::hypot(kAway + kRadius, kLength / 2);
    EXPECT_GE(row.uncovered.bound, furthest - 1e-8);
    EXPECT_LE(row.uncovered.found, furthest + 1e-8);
  }
}

/// A can, and a thin shell around its surface that covers all of it, but not the sides of the polyhedron in it.
TEST(LinkPair, WhatTheSidesOfThePolyhedronInARoundOriginalLackIsNotFound) {
  constexpr double kRadius = 0.2, kLength = 0.1, kThick = 0.01, kHalfAngle = test_shapes::kPi / 100;
  LinkBodies original, result;
  original.primitives.push_back(roundElement(Kind::kCylinder, kRadius, kLength));
  const Eigen::Isometry3d& place = original.primitives[0].origin;
  for (const double z : {-kLength / 2, kLength / 2}) {
    result.primitives.push_back(boxElement({1, 1, kThick}, {0, 0, z}));
    result.primitives.back().origin = place * result.primitives.back().origin;
  }
  for (double angle = 0; angle < 2 * test_shapes::kPi; angle += 2 * kHalfAngle) {
    const double inner = kRadius * std::cos(kHalfAngle) - 1e-9, width = 2 * (kRadius + kThick) * std::tan(kHalfAngle);
    GeometryElement slat = boxElement({kThick, width, kLength}, {inner + kThick / 2, 0, 0});
    slat.origin = place * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * slat.origin;
    result.primitives.push_back(slat);
  }
  LinkVerification row;
  row.diagonal = 0.5;
  LinkPair(original, result).measure(row);
  EXPECT_EQ(row.uncovered.found, 0);
  EXPECT_GT(row.uncovered.bound, 0);
}

/// A bracket whose one leg bridges two boxes: midway, where it has no corner, it is furthest from both.
TEST(LinkPair, AMeshThatIsNotConvexProtrudesByItsWholeDistance) {
  LinkBodies original, result;
  for (const double x : {-0.5, 1.5}) original.primitives.push_back(boxElement({1, 3, 3}, {x, 0, 0}));
  const TriangleMesh bracket = moved(lBracket(1.37, 0.1, 1), {-0.21, -0.5, -0.5});
  result.meshes.push_back({bracket, {{}, bracket, 1}});
  LinkVerification row;
  row.diagonal = 5;
  LinkPair(original, result).measure(row);
  EXPECT_GE(row.protrusion.bound, 0.5);
  EXPECT_LE(row.protrusion.bound, 0.51);
  EXPECT_LT(row.protrusion.found, 0.5);
}

}  // namespace
}  // namespace collision_hulls
