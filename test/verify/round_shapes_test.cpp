// Spheres and cylinders against closed forms, and the polyhedra that stand for them.
#include "verify/round_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verify_shapes.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;
using namespace test_shapes;

TEST(RoundShapes, ThePolyhedraEncloseTheShapeBetweenThem) {
  for (const GeometryElement& shape : {roundElement(Kind::kSphere, 0.2), roundElement(Kind::kCylinder, 0.2, 0.5)}) {
    const Approximation in = inscribed(shape), out = circumscribed(shape);
    EXPECT_LT(in.error, 0.006 * 0.2);
    EXPECT_LT(out.error, 0.006 * 0.2);
    for (const Eigen::Vector3d& v : in.hull.vertices) EXPECT_LT(distance(shape, v), 1e-12);
    for (const Eigen::Vector3d& v : in.hull.vertices) EXPECT_TRUE(planeDistance(out.hull, v) < 1e-12);
    for (const HalfSpace& face : out.hull.faces) {  // the shape reaches no further than the polyhedron around it
      const Eigen::Vector3d far = shape.origin.translation() + 10 * face.normal;
      EXPECT_LE(face.distance(far) - distance(shape, far), 1e-9);
    }
    test_shapes::RandomPoints random(3);
    for (int i = 0; i < 200; ++i) {  // points on the shape
      const Eigen::Vector3d far = shape.origin.translation() + 10 * random.onSphere();
      const double to_shape = distance(shape, far), to_inner = distance(in.hull, far), to_outer = distance(out.hull, far);
      EXPECT_LE(to_shape, to_inner + 1e-9);
      EXPECT_GE(to_shape + in.error, to_inner - 1e-9);
      EXPECT_GE(to_shape, to_outer - 1e-9);
    }
  }
}

TEST(RoundShapes, AHullHoldsWhatItsFacesLeaveRoomFor) {
  const GeometryElement can = roundElement(Kind::kCylinder, 0.2, 0.5);
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(can.origin * Eigen::Vector3d(i & 1 ? 0.2 : -0.2, i & 2 ? 0.2 : -0.2, i & 4 ? 0.25 : -0.25));
  EXPECT_TRUE(holds(convexHull(corners), can));
  for (const Eigen::Vector3d& shrunk : {Eigen::Vector3d(0.999, 1, 1), Eigen::Vector3d(1, 0.999, 1), Eigen::Vector3d(1, 1, 0.999)}) {
    std::vector<Eigen::Vector3d> less = corners;
    for (Eigen::Vector3d& corner : less) corner = can.origin * shrunk.cwiseProduct(can.origin.inverse() * corner);
    EXPECT_FALSE(holds(convexHull(less), can)) << shrunk.transpose();
  }
}

TEST(RoundShapes, EqualBodiesMayDifferInATurnThatChangesNothing) {
  const GeometryElement can = roundElement(Kind::kCylinder, 0.2, 0.5), ball = roundElement(Kind::kSphere, 0.2);
  GeometryElement turned = can, turned_ball = ball, upside_down = can;
  turned.origin.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitZ()));
  turned_ball.origin.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()));
  upside_down.origin.rotate(Eigen::AngleAxisd(test_shapes::kPi, Eigen::Vector3d::UnitX()));
  EXPECT_EQ(apartAtMost(can, turned), 0);
  EXPECT_EQ(apartAtMost(can, upside_down), 0);
  EXPECT_EQ(apartAtMost(ball, turned_ball), 0);
  EXPECT_TRUE(std::isinf(apartAtMost(can, ball)));
}

/// Shifted, turned and resized each by itself, along what makes the bound tight.
TEST(RoundShapes, ABoundOnTheDifferenceOfTwoBodiesHoldsAndIsClose) {
  const auto expect = [](const GeometryElement& a, const GeometryElement& b, double apart, double slack, const char* what) {
    EXPECT_GE(apartAtMost(a, b), apart * (1 - 1e-9)) << what;
    EXPECT_LE(apartAtMost(a, b), apart * slack + 1e-11) << what;
  };
  constexpr double kLittle = 2e-5;
  const Eigen::AngleAxisd tilt(kLittle, Eigen::Vector3d::UnitX());
  for (const Kind kind : {Kind::kSphere, Kind::kCylinder, Kind::kBox}) {
    const GeometryElement body = kind == Kind::kBox ? boxElement({0.2, 0.3, 1}, {1, 2, 3}) : roundElement(kind, 0.01, 1);
    GeometryElement shifted = body, larger = body;
    shifted.origin.translate(Eigen::Vector3d(kLittle, 0, 0));
    expect(body, shifted, kLittle, 1, "shifted");
    larger.size.x() += 2 * kLittle;
    expect(body, larger, kind == Kind::kBox ? kLittle : 2 * kLittle, 1, "larger");
    expect(larger, body, kind == Kind::kBox ? kLittle : 2 * kLittle, 1, "smaller");
  }
  GeometryElement can = roundElement(Kind::kCylinder, 0.01, 1), longer = can, tilted = can;
  GeometryElement turned = boxElement({0.01, 0.01, 1}, {0, 0, 0});
  longer.size.y() += 2 * kLittle;
  expect(can, longer, kLittle, 1, "longer");
  tilted.origin.rotate(tilt);
  expect(can, tilted, kLittle / 2, 1.001, "tilted");
  turned.origin.rotate(tilt);
  expect(boxElement({0.01, 0.01, 1}, {0, 0, 0}), turned, kLittle / 2, 1.5, "a turned box");
}

}  // namespace
}  // namespace collision_hulls
