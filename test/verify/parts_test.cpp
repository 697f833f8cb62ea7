// The pieces of verify: which components are convex, round shapes, and the searches against closed forms.
// Also tests src/verify/mesh_protrusion.cpp.
#include <gtest/gtest.h>

#include "counted_looks.h"
#include "mesh/loose_segments.h"
#include "octahedron.h"
#include "solids.h"
#include "verify/compare_link.h"
#include "verify/convex_parts.h"
#include "verify/cover_search.h"
#include "verify/mesh_protrusion.h"
#include "verify/round_shapes.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;
using test_shapes::box;
using test_shapes::lBracket;
using test_shapes::merged;
using test_shapes::moved;
using test_shapes::solidOf;

GeometryElement round(Kind kind, double radius, double length = 0) {
  GeometryElement element;
  element.kind = kind;
  element.size = {radius, length, 0};
  element.origin = Eigen::Translation3d(0.3, -0.2, 0.1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  return element;
}

TEST(ConvexParts, HullsAreToldFromTheRest) {
  const ConvexParts parts = convexParts(merged({box(1, 1, 1, 3), lBracket(), moved(box(1, 1, 1), {0.5, 0.5, 0.5}), test_shapes::sheet()}));
  EXPECT_EQ(parts.hulls.size(), 2u);
  EXPECT_EQ(parts.rest_parts, 2u);
  EXPECT_EQ(parts.rest.triangles.size(), lBracket().triangles.size() + test_shapes::sheet().triangles.size());
}

TEST(ConvexParts, LooksAtEachTriangleOfEachPass) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 60);
  const std::size_t pass = sheet.triangles.size() / kLargeItemsBetweenLooks;
  ASSERT_GT(pass, 20u);
  EXPECT_GE(looksOf([&](const RunControl& control) { convexParts(sheet, control); }), 3 * pass) << "runs, their triangles, its component's";
}

TEST(ConvexParts, AThinPlateAndASphereAreConvex) {
  EXPECT_EQ(convexParts(box(1, 1, 1e-4)).hulls.size(), 1u);
  EXPECT_EQ(convexParts(test_shapes::sphere(1, 6)).hulls.size(), 1u);
}

TEST(ConvexParts, ADentIsNotConvex) {
  TriangleMesh dented = box(1, 1, 1, 4);
  for (Eigen::Vector3d& v : dented.vertices)
    if (std::abs(v.z() - 1) < 1e-9 && std::abs(v.x() - 0.5) < 1e-9 && std::abs(v.y() - 0.5) < 1e-9) v.z() -= 1e-4;
  EXPECT_EQ(convexParts(dented).hulls.size(), 0u);
}

TEST(ConvexParts, InsideOutIsStillABody) {
  TriangleMesh cube = box(1, 1, 1);
  for (Triangle& t : cube.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(convexParts(cube).hulls.size(), 1u);
}

/// Triangles without an area, from each point to itself moved.
TriangleMesh needles(const std::vector<Eigen::Vector3d>& from, const Eigen::Vector3d& by) {
  TriangleMesh mesh;
  for (const Eigen::Vector3d& p : from) addSegment(mesh, {p, p + by});
  return mesh;
}

TEST(ConvexParts, ALooseTriangleInAHullIsNoRest) {
  const std::vector<Eigen::Vector3d> inside{{0.2, 0.2, 0.2}, {2.2, 0.5, 0.5}}, across{{0.8, 0.5, 0.5}}, beside{{5, 5, 5}};
  const Eigen::Vector3d by(0.5, 0, 0);
  const std::vector<TriangleMesh> cubes{box(1, 1, 1), moved(box(1, 1, 1), {2, 0, 0})};
  const auto rest = [&](const TriangleMesh& loose, bool first) {
    const ConvexParts parts = convexParts(first ? merged({loose, cubes[0], cubes[1]}) : merged({cubes[0], cubes[1], loose}));
    EXPECT_EQ(parts.hulls.size(), 2u);
    return parts.rest.triangles.size();
  };
  for (const bool first : {true, false}) {
    EXPECT_EQ(rest(needles(inside, by), first), 0u) << first;
    EXPECT_EQ(rest(needles(across, by), first), 1u) << first;
    EXPECT_EQ(rest(needles(beside, by), first), 1u) << first;
  }
  EXPECT_EQ(rest(needles({{0, 0, 0}, {2, 0, 0}}, {1, 1, 1}), false), 0u) << "from corner to corner";
}

TEST(ConvexParts, ALooseTriangleIsComparedWithTheHullsNearIt) {
  constexpr int kCubes = 300;
  TriangleMesh row;
  std::vector<Eigen::Vector3d> inside;
  for (int i = 0; i < kCubes; ++i) {
    append(row, moved(box(1, 1, 1), {2.0 * i, 0, 0}));
    inside.emplace_back(2 * i + 0.2, 0.2, 0.2);
  }
  const TriangleMesh loose = needles(inside, {0.5, 0.1, 0.1});
  const auto looks = [](const TriangleMesh& mesh) { return looksOf([&](const RunControl& control) { convexParts(mesh, control); }); };
  const std::size_t apart = looks(row) + looks(loose), together = looks(merged({row, loose}));
  EXPECT_GE(together, apart + kCubes) << "each with the hull around it";
  EXPECT_LE(together, apart + 4 * kCubes) << "and with hardly any other";
}

/// Octahedra in one another, and triangles in the corners of their boxes, which none of them holds.
TEST(ConvexParts, ALooseTriangleInManyBoxesLooksAtEach) {
  constexpr std::size_t kHulls = 60;
  TriangleMesh mesh;
  for (std::size_t i = 0; i < kHulls; ++i) {
    const double size = 1 + 0.01 * static_cast<double>(i);
    std::vector<Eigen::Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis) corners.emplace_back(size * Eigen::Vector3d::Unit(axis)), corners.emplace_back(-corners.back());
    append(mesh, surface(convexHull(corners)));
  }
  std::vector<Eigen::Vector3d> outside;
  for (std::size_t i = 0; i < kHulls; ++i) outside.emplace_back(0.9, 0.9, 0.9 - 0.001 * static_cast<double>(i));
  append(mesh, needles(outside, {0.01, 0, 0}));
  const auto work = [&](const RunControl& control) { EXPECT_EQ(convexParts(mesh, control).rest.triangles.size(), kHulls); };
  const std::size_t looks = looksOf(work);
  EXPECT_GE(looks, kHulls * kHulls);
  EXPECT_EQ(looksAfterCancel(looks - kHulls, work), 1u);
}

TEST(RoundShapes, ThePolyhedraEncloseTheShapeBetweenThem) {
  for (const GeometryElement& shape : {round(Kind::kSphere, 0.2), round(Kind::kCylinder, 0.2, 0.5)}) {
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
  const GeometryElement can = round(Kind::kCylinder, 0.2, 0.5);
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
  const GeometryElement can = round(Kind::kCylinder, 0.2, 0.5), ball = round(Kind::kSphere, 0.2);
  GeometryElement turned = can, tilted = can, turned_ball = ball;
  turned.origin.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitZ()));
  tilted.origin.rotate(Eigen::AngleAxisd(1e-3, Eigen::Vector3d::UnitX()));
  turned_ball.origin.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(equalBodies(can, turned));
  EXPECT_FALSE(equalBodies(can, tilted));
  EXPECT_TRUE(equalBodies(ball, turned_ball));
  EXPECT_FALSE(equalBodies(can, ball));
}

/// A wall of spheres that just covers a square, and one that does not.
TEST(CoverSearch, SpheresThatOverlapEnoughCover) {
  for (const double radius : {0.0708, 0.0700}) {
    LinkBodies bodies;
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j) {
        GeometryElement ball;
        ball.kind = Kind::kSphere;
        ball.size.x() = radius;
        ball.origin = Eigen::Translation3d(0.05 + 0.1 * i, 0.05 + 0.1 * j, 0);
        bodies.primitives.push_back(ball);
      }
    const Largest largest = furthestFrom(BodySet(bodies), test_shapes::sheet(1, 1), 1e-6);
    const double expected = std::max(0.0, 0.05 * std::sqrt(2.0) - radius);  // at the corners of the spheres' squares
    EXPECT_NEAR(largest.found, expected, 1e-5);
    EXPECT_GE(largest.bound, expected);
    EXPECT_LE(largest.bound, 1.011 * expected + 2e-6);
  }
}

TEST(CoverSearch, HullsAndAMeshCoverTogether) {
  LinkBodies bodies;
  bodies.meshes.push_back({lBracket(1, 0.2, 1), convexParts(lBracket(1, 0.2, 1))});
  const TriangleMesh beside = moved(box(0.5, 0.5, 1), {0.2, 0.2, 0});
  bodies.meshes.push_back({beside, convexParts(beside)});
  const BodySet set(bodies);
  ASSERT_TRUE(set.rest());
  ASSERT_EQ(set.hulls().size(), 1u);
  const TriangleMesh across = moved(box(0.6, 0.6, 0.5), {0.05, 0.05, 0.25});  // in both of them
  EXPECT_LT(furthestFrom(set, across, 1e-4).bound, 2e-3);
  const Largest out = furthestFrom(set, moved(across, {0.1, 0, 0}), 1e-4);
  EXPECT_NEAR(out.found, 0.05, 2e-3);
  EXPECT_GE(out.bound, 0.05);
}

/// A mesh whose upper faces, at z = 1, have vertices of their own, higher by this, to which repair() welds them.
TriangleMesh withLooseTop(TriangleMesh mesh, double higher) {
  std::vector<Eigen::Vector3d>& vertices = mesh.vertices;
  for (Triangle& t : mesh.triangles) {
    if (std::any_of(t.begin(), t.end(), [&](int v) { return vertices[static_cast<std::size_t>(v)].z() < 1; })) continue;
    for (int& v : t) {
      vertices.emplace_back(vertices[static_cast<std::size_t>(v)] + higher * Eigen::Vector3d::UnitZ());
      v = static_cast<int>(vertices.size()) - 1;
    }
  }
  return mesh;
}

constexpr double kHigher = 5e-6;  // half of what is welded in a mesh of 1 m

GeometryElement boxElement(const Eigen::Vector3d& size, const Eigen::Vector3d& place) {
  GeometryElement element;
  element.kind = Kind::kBox;
  element.size = size;
  element.origin = Eigen::Translation3d(place);
  return element;
}

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
    original.primitives.push_back(round(is_sphere ? Kind::kSphere : Kind::kCylinder, 0.2, 0.2));
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
    original.primitives.push_back(round(Kind::kSphere, 0.2, 0));
    const Eigen::Vector3d place = original.primitives[0].origin * (0.3 * random.onSphere());
    const double radius = i % 2 ? 0.05 : 0;
    GeometryElement ball = round(Kind::kSphere, radius, 0);
    ball.origin = Eigen::Translation3d(place);
    result.primitives.push_back(radius > 0 ? ball : boxElement(Eigen::Vector3d::Constant(1e-9), place));
    LinkVerification row;
    row.diagonal = 0.2 * std::sqrt(12.0);
    LinkPair(original, result).measure(row);
    EXPECT_LE(row.protrusion.found, 0.1 + radius + 1e-8) << i;
    EXPECT_GE(row.protrusion.bound, 0.1 + radius - 1e-8) << i;
  }
}

TEST(CoverSearch, NoPlaceBetweenSpheresIsFurtherThanTheBound) {
  LinkBodies bodies;
  for (int k = 0; k < 4; ++k) {
    GeometryElement ball;
    ball.kind = Kind::kSphere;
    ball.size.x() = 0.5;
    ball.origin = Eigen::Translation3d(k & 1 ? 1 : 0, k & 2 ? 1 : 0, 0);
    bodies.primitives.push_back(ball);
  }
  const BodySet set(bodies);
  test_shapes::RandomPoints random(9);
  for (int i = 0; i < 10; ++i) {  // sheets about the place in the middle of all four
    const TriangleMesh sheet = moved(test_shapes::sheet(0.6, 0.6), {random.number(0.1, 0.3), random.number(0.1, 0.3), 0});
    EXPECT_GE(furthestFrom(set, sheet, 0.02).bound, std::sqrt(0.5) - 0.5 - 1e-12) << i;
  }
}

TEST(CoverSearch, WhatAMeshLeavesCountsHowFarItsVerticesWereMoved) {
  LinkBodies bodies;
  bodies.meshes.push_back({{}, {}});
  bodies.meshes.back().parts.rest = withLooseTop(lBracket(), kHigher);
  const BodySet set(bodies);
  const Largest largest = furthestFrom(set, moved(test_shapes::sheet(0.02, 0.02), {0.5, 0.04, 1.1}), 1e-9);
  EXPECT_GE(largest.bound, set.whole()->distance(largest.where) + kHigher);
  EXPECT_LE(largest.bound, 0.1 + 2 * kHigher + 1e-6);
  EXPECT_LE(largest.found, 0.1 - kHigher + 1e-9);
}

/// The summit is anywhere in the body, and nothing on the body's surface is as far away.
TEST(MeshProtrusion, NoSummitIsBeyondTheBound) {
  test_shapes::RandomPoints random(10);
  const Solid solid = solidOf(test_shapes::octahedronOfSheets(0.3));
  for (int i = 0; i < 40; ++i) {
    const Eigen::Isometry3d pose = Eigen::Translation3d(random.inCube(0.03)) * Eigen::Isometry3d(random.rotation());
    const TriangleMesh body = transformed(moved(box(0.15, 0.15, 0.15), {-0.075, -0.075, -0.075}), pose);
    const Protrusion far = meshProtrusion(body, solidOf(body), solid, 1e-3);
    EXPECT_GE(far.bound, 0.3) << i;
    EXPECT_LE(far.bound, 0.305) << i;
  }
}

/// The search inside is of the body as it was welded.
TEST(MeshProtrusion, CountsHowFarTheBodysVerticesWereMoved) {
  const TriangleMesh body = withLooseTop(lBracket(), kHigher);
  const Protrusion far = meshProtrusion(body, solidOf(body), solidOf(moved(box(2, 2, 3), {-0.5, -0.5, -0.5})), 1e-9);
  EXPECT_NEAR(far.bound, kHigher, 1e-8);
}

/// The surface of the bracket in triangles that do not touch, so that it encloses nothing: then the body's inside is further from it than
/// anything on the body's surface. Its largest inscribed ball touches both outer sides and the inner edge.
TEST(MeshProtrusion, TheInsideOfABodyCounts) {
  const double t = 0.2;
  const TriangleMesh body = lBracket(1, t, 1, 8);
  TriangleMesh apart;
  for (int i = 0; i < static_cast<int>(body.triangles.size()); ++i) {
    const Eigen::Vector3d centre = (body.corner(i, 0) + body.corner(i, 1) + body.corner(i, 2)) / 3;
    for (int k = 0; k < 3; ++k) apart.vertices.push_back(centre + 0.98 * (body.corner(i, k) - centre));
    apart.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const double radius = t * std::sqrt(2.0) / (1 + std::sqrt(2.0));
  const Solid sheets = solidOf(apart), solid = solidOf(body);
  const Protrusion far = meshProtrusion(body, solid, sheets, 1e-3);
  EXPECT_GE(far.bound, radius);
  EXPECT_LE(far.bound, radius + 5e-3);
  EXPECT_NEAR(far.found, radius, 5e-3);
  EXPECT_LT(largestOnMesh(body, sheets, 1e-3).bound, 0.01);
  EXPECT_LT(meshProtrusion(body, solid, solid, 1e-3).bound, 1e-2);
}

/// A box with a window, and the same box filled up but for a pit below the window. The middle of the window is further from that than
/// anything else of the body, but no summit: further up it would be further still, only that is no longer in the body.
TEST(MeshProtrusion, AllOfTheInsideCountsWhereItEndsInMidAir) {
  const TriangleMesh body = test_shapes::boxWithWindow(0.2);
  const TriangleMesh pitted = moved(test_shapes::squareVessel({{0.5, 0}, {0.5, 1}, {0.2, 1}, {0.001, 0.801}}), {0.5, 0.5, 0});
  const Protrusion far = meshProtrusion(body, solidOf(body), solidOf(pitted), 0.03);
  EXPECT_GE(far.bound, 0.2 / std::sqrt(2.0));
  EXPECT_LE(far.bound, 0.2 / std::sqrt(2.0) + 0.03);
}

}  // namespace
}  // namespace collision_hulls
