#include "collision_hulls/primitives/covering_primitive.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using Kind = PrimitiveKind;
using namespace test_shapes;

Eigen::Isometry3d anyPose(RandomPoints& random) {
  return Eigen::Translation3d(random.inCube()) * Eigen::Isometry3d(random.rotation());
}

TriangleMesh cylinderMesh(int sides, double radius, double length) {
  std::vector<Eigen::Vector2d> outline;
  std::vector<Triangle> cap;
  for (int i = 0; i < sides; ++i) outline.emplace_back(radius * std::cos(2 * kPi * i / sides), radius * std::sin(2 * kPi * i / sides));
  for (int i = 2; i < sides; ++i) cap.push_back({0, i - 1, i});
  return prism(outline, cap, length);
}

PrimitiveOptions within(double tolerance) {
  PrimitiveOptions options;
  options.tolerance = tolerance;
  return options;
}

/// The best that a few thousand points of a primitive find.
double sampledProtrusion(const Primitive& primitive, const Solid& solid, RandomPoints& random) {
  double most = 0;
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3d p = nearestPoint(primitive, primitive.pose * random.inCube(2 * primitive.size.sum()));
    most = std::max(most, solid.distance(p));
  }
  return most;
}

TEST(CoveringPrimitive, BoxesAreBoxes) {
  RandomPoints random(1);
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh mesh = transformed(box(0.3, 0.5, 1.1), anyPose(random));
    const auto found = coveringPrimitive(hullOf(mesh), solidOf(mesh), within(1e-4));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->primitive.kind, Kind::kBox);
  }
}

TEST(CoveringPrimitive, FacettedCylindersAndSpheresAreRecognised) {
  RandomPoints random(2);
  for (int i = 0; i < 2; ++i) {
    const TriangleMesh bar = transformed(cylinderMesh(32, 0.1, 0.5), anyPose(random)), ball = transformed(sphere(0.2, 6), anyPose(random));
    const auto cylinder = coveringPrimitive(hullOf(bar), solidOf(bar), within(0.01 * diagonal(bar)));
    ASSERT_TRUE(cylinder);
    EXPECT_EQ(cylinder->primitive.kind, Kind::kCylinder);
    const CertifiedPrimitive close = certificate(cylinder->primitive, solidOf(bar), 0, 0.01 * diagonal(bar));
    EXPECT_NEAR(close.found, 0.1 * (1 - std::cos(kPi / 32)), 1e-5);  // the facets' sagitta
    const auto round = coveringPrimitive(hullOf(ball), solidOf(ball), within(0.01 * diagonal(ball)));
    ASSERT_TRUE(round);
    EXPECT_EQ(round->primitive.kind, Kind::kSphere);
  }
}

TEST(CoveringPrimitive, NoneCoversABracket) {
  const TriangleMesh mesh = lBracket();
  EXPECT_FALSE(coveringPrimitive(hullOf(mesh), solidOf(mesh), within(0.05)));
}

TEST(CoveringPrimitive, TakesTheFirstKindThatStaysWithin) {
  const TriangleMesh mesh = box(0.3, 0.5, 1.1);
  PrimitiveOptions options = within(1);
  for (const Kind kind : allPrimitiveKinds()) {
    options.kinds = {kind, Kind::kBox};
    EXPECT_EQ(coveringPrimitive(hullOf(mesh), solidOf(mesh), options)->primitive.kind, kind);
  }
  options.tolerance = 1e-3;
  EXPECT_EQ(coveringPrimitive(hullOf(mesh), solidOf(mesh), options)->primitive.kind, Kind::kBox);
}

TEST(PrimitiveOfKind, NoPointIsBeyondTheBoundAndSomeAreNear) {
  RandomPoints random(3);
  for (const TriangleMesh& mesh : {lBracket(), uChannel(), flask(), torus(), sheet(), singleTriangle(), boxWithWindow()})
    for (const Kind kind : allPrimitiveKinds()) {
      const Solid solid = solidOf(mesh);
      const CertifiedPrimitive result = primitiveOfKind(kind, hullOf(mesh), solid, within(0.01));
      EXPECT_LE(sampledProtrusion(result.primitive, solid, random), result.bound) << name(kind);
      EXPECT_LE(result.found, result.bound);
      EXPECT_NEAR(solid.distance(result.where), result.found, 1e-12);
      EXPECT_LE(distance(result.primitive, result.where), 1e-12);
      EXPECT_GE(result.found, 0.96 * result.bound - 0.001) << name(kind);
    }
}

TEST(PrimitiveOfKind, OfACubeInASphere) {
  const TriangleMesh mesh = moved(box(2, 2, 2), {-1, -1, -1});
  const CertifiedPrimitive result = primitiveOfKind(Kind::kSphere, hullOf(mesh), solidOf(mesh), within(0.01));
  EXPECT_NEAR(result.bound, std::sqrt(3.0) - 1, 0.03 * result.bound);
  EXPECT_GE(result.bound, std::sqrt(3.0) - 1);
}

TEST(PrimitiveOfKind, TheMarginIsPartOfTheBound) {
  const TriangleMesh mesh = box(1, 1, 1);
  PrimitiveOptions options = within(0.1);
  options.margin = 0.05;
  EXPECT_GE(primitiveOfKind(Kind::kBox, hullOf(mesh), solidOf(mesh), options).bound, 0.05);
  options.tolerance = 0.04;
  EXPECT_FALSE(coveringPrimitive(hullOf(mesh), solidOf(mesh), options));
}

TEST(CoveringPrimitive, IsTakenWithinItsToleranceAndNotBelow) {
  const TriangleMesh mesh = cylinderMesh(32, 0.1, 0.5);
  const Solid solid = solidOf(mesh);
  PrimitiveOptions options = within(0.01);
  options.kinds = {Kind::kCylinder};
  const double sagitta = 0.1 * (1 - std::cos(kPi / 32));
  for (const double share : {0.97, 1.05, 2.0, 20.0}) {
    options.tolerance = share * sagitta;
    const auto found = coveringPrimitive(hullOf(mesh), solid, options);
    EXPECT_EQ(found.has_value(), share > 1) << share;
    if (found) {
      EXPECT_LE(found->bound, options.tolerance);
    }
  }
}

TEST(CoveringPrimitive, TheBoundOfABarIsThatOfThePolyhedronAroundIt) {
  const TriangleMesh mesh = cylinderMesh(32, 0.1, 0.5);
  PrimitiveOptions options = within(0.003);
  options.kinds = {Kind::kCylinder};
  EXPECT_TRUE(coveringPrimitive(hullOf(mesh), solidOf(mesh), options));
  options.bar_excess = 0.05;  // 5 mm
  EXPECT_FALSE(coveringPrimitive(hullOf(mesh), solidOf(mesh), options));
  EXPECT_LT(primitiveOfKind(Kind::kCylinder, hullOf(mesh), solidOf(mesh), within(0.003)).bound, 0.002);
  EXPECT_GT(primitiveOfKind(Kind::kCylinder, hullOf(mesh), solidOf(mesh), options).bound, 0.004);
}

TEST(Certificate, OfNoPrimitivesIsZero) {
  const Solid far = solidOf(moved(box(1, 1, 1), {5, 0, 0}));
  const CertifiedPrimitive proof = certificate(std::vector<Primitive>{}, far, within(0.01));
  EXPECT_EQ(proof.bound, 0);
  EXPECT_EQ(proof.found, 0);
}

TEST(Certificate, OfSeveralPrimitivesIsThatOfTheWorst) {
  const TriangleMesh mesh = box(1, 1, 1);
  const Solid solid = solidOf(mesh);
  Primitive near = enclosingPrimitive(Kind::kBox, hullOf(mesh)), far = near;
  far.size.x() += 0.2;
  const CertifiedPrimitive proof = certificate(std::vector<Primitive>{near, far, near}, solid, within(0.01));
  EXPECT_NEAR(proof.found, 0.1, 1e-4);
  EXPECT_NEAR(proof.bound, 0.1, 1e-3);
  EXPECT_GE(proof.bound, 0.1);
  EXPECT_EQ(proof.primitive.size, far.size);
}

TEST(CoveringPrimitive, NeedsATolerance) {
  const TriangleMesh mesh = box(1, 1, 1);
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(coveringPrimitive(hullOf(mesh), solidOf(mesh), within(tolerance)), Error);
}

TEST(CoveringPrimitive, RefusesMarginsThatAreNone) {
  const TriangleMesh mesh = box(1, 1, 1);
  for (const double margin : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    PrimitiveOptions options = within(0.1);
    options.margin = margin;
    EXPECT_THROW(coveringPrimitive(hullOf(mesh), solidOf(mesh), options), Error);
    EXPECT_THROW(certificate(enclosingPrimitive(Kind::kBox, hullOf(mesh)), solidOf(mesh), margin, 0.1), Error);
  }
}

}  // namespace
}  // namespace collision_hulls
