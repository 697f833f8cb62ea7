#include "measure/protrusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "box_with_slit.h"
#include "collision_hulls/measure/measures.h"
#include "geometry/hull_support.h"
#include "octahedron.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;
using test_shapes::hullOf;
using test_shapes::inHull;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

/// What measures.h promises for every result, whatever the truth is.
void expectConsistent(const Protrusion& p, const std::vector<ConvexHull>& hulls, const Solid& solid, double gap) {
  EXPECT_LE(p.found, p.bound);
  double beyond = 0;
  for (const ConvexHull& hull : hulls) beyond = std::max(beyond, overhang(hull));
  EXPECT_LE(p.bound - p.found, gap * (1 + 1e-9) + beyond);
  if (p.found == 0) return;
  ASSERT_GE(p.hull, 0);
  const double rounding = 1e-9 * boundingBox(hulls[static_cast<std::size_t>(p.hull)]).diagonal().norm();
  EXPECT_LE(planeDistance(hulls[static_cast<std::size_t>(p.hull)], p.where), rounding);
  EXPECT_NEAR(solid.distance(p.where), p.found, rounding);
  EXPECT_NEAR((p.where - p.nearest).norm(), p.found, rounding);
}

Protrusion checkedProtrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, double gap) {
  const Protrusion p = protrusion(hulls, solid, gap);
  expectConsistent(p, hulls, solid, gap);
  return p;
}

void expectProtrusion(double expected, const std::vector<ConvexHull>& hulls, const Solid& solid, double gap = 0.01) {
  const Protrusion p = checkedProtrusion(hulls, solid, gap);
  const double rounding = 1e-11 * boundingBox(hulls[0]).diagonal().norm();  // hulls' planes lie outside their vertices
  EXPECT_LE(p.found, expected + rounding);
  EXPECT_GE(p.bound, expected - rounding);
}

// The planes of all their sides cut the hull's long facets. Cut at the wrong edges, these fall into millions of slivers.
TEST(Protrusion, ARowOfBoxesInOneHull) {
  constexpr double kSide = 0.0189, kPitch = 1.8918 * kSide, kGap = 1e-5;
  std::vector<TriangleMesh> boxes;
  for (int i = 0; i < 32; ++i) boxes.push_back(test_shapes::moved(test_shapes::box(kSide, kSide, kSide), {0, i * kPitch, 0}));
  const TriangleMesh row = test_shapes::merged(boxes);
  const Protrusion p = protrusion({convexHull(row.vertices)}, solidOf(row), kGap);
  EXPECT_NEAR(p.found, (kPitch - kSide) / 2, kGap);
  EXPECT_LT(p.bound, 1.02 * p.found) << "not to the gap: all of the middle between two boxes is as far";
}

// Degenerate input.

TEST(Protrusion, NoHulls) {
  const Protrusion p = protrusion({}, solidOf(test_shapes::box(1, 1, 1)), 0.01);
  EXPECT_EQ(p.bound, 0);
  EXPECT_EQ(p.hull, -1);
}

/// A room [0, 1]^3 of six crossing slabs, much larger than it.
Solid roomOfSlabs() {
  constexpr double kFar = 20, kThick = 9;
  std::vector<TriangleMesh> slabs;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double from : {-kThick, 1.0}) {
      Vector3d low = Vector3d::Constant(-kFar), size = Vector3d::Constant(2 * kFar);
      low[axis] = from, size[axis] = from < 0 ? -from : kThick - from;
      slabs.push_back(test_shapes::moved(test_shapes::box(size.x(), size.y(), size.z()), low));
    }
  }
  return solidOf(test_shapes::merged(slabs));
}

// The hull's surface is deep in the slabs, and so is the mean of its vertices; its furthest point is the middle of the room.
TEST(Protrusion, ARoomWithinTheHull) {
  const Solid room = roomOfSlabs();
  expectProtrusion(0.5, {boxHull({-0.1, -0.1, -5}, {1.1, 1.1, 1.1})}, room);
  expectProtrusion(0.5, {boxHull({-1.2, -1.1, -2.3}, {2, 2.3, 1})}, room, 0.001);
  std::vector<Vector3d> corners = boxHull({0, 0, 0}, {1, 1, 1}).vertices;
  corners.emplace_back(1.37, 0.5, 0.5);
  expectProtrusion(0.5, {convexHull(corners)}, room);
}

TEST(Protrusion, APlateAroundASheet) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 3);
  const ConvexHull plate = hullOf(sheet);
  const Protrusion p = checkedProtrusion({plate}, solidOf(sheet), 0.001);
  EXPECT_NEAR(p.found, plate.thickness / 2, 1e-3 * plate.thickness);
}

TEST(Protrusion, AroundPointsAndSegments) {
  const Solid point = solidOf({{{1, 1, 1}}, {{0, 0, 0}}});
  expectProtrusion(std::sqrt(3.0), {boxHull({0, 0, 0}, {2, 2, 2})}, point);
  const Solid segment = solidOf({{{0, 0, 0}, {3, 0, 0}}, {{0, 1, 1}}});
  expectProtrusion(std::sqrt(2.0), {boxHull({0, -1, -1}, {3, 1, 1})}, segment);
}

TEST(Protrusion, CanBeCancelled) {
  RunControl control;
  control.cancel();
  try {
    protrusion({hullOf(test_shapes::openBox())}, solidOf(test_shapes::openBox()), 1e-3, control);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

// Closed-form answers.

TEST(Protrusion, ExactBoxesHaveNone) {
  const TriangleMesh bracket = test_shapes::lBracket(1, 0.1, 1, 3);
  expectProtrusion(0, {boxHull({0, 0, 0}, {1, 0.1, 1}), boxHull({0, 0, 0}, {0.1, 1, 1})}, solidOf(bracket));
  const TriangleMesh far = test_shapes::moved(bracket, {1e4, -1e4, 1e4});
  const Vector3d at(1e4, -1e4, 1e4);
  expectProtrusion(0, {boxHull(at, at + Vector3d(1, 0.1, 1)), boxHull(at, at + Vector3d(0.1, 1, 1))}, solidOf(far), 0.001);
  expectProtrusion(0, {hullOf(test_shapes::sphere(1, 6))}, solidOf(test_shapes::sphere(1, 6)), 0.001);
}

TEST(Protrusion, FilledShapes) {
  for (int n : {1, 3}) {
    SCOPED_TRACE(n);
    expectProtrusion(0.45, {hullOf(test_shapes::lBracket())}, solidOf(test_shapes::lBracket(1, 0.1, 1, n)));
    expectProtrusion(0.4, {hullOf(test_shapes::uChannel())}, solidOf(test_shapes::uChannel(1, 1, 0.1, 2, n)));
    expectProtrusion(0.3, {hullOf(test_shapes::uChannel(1, 0.4, 0.1, 2))}, solidOf(test_shapes::uChannel(1, 0.4, 0.1, 2, n)));
    expectProtrusion(0.45, {hullOf(test_shapes::openBox())}, solidOf(test_shapes::openBox(1, 1, 1, 0.05, n)));
    expectProtrusion(0.15, {hullOf(test_shapes::openBox(1, 1, 0.2))}, solidOf(test_shapes::openBox(1, 1, 0.2, 0.05, n)));
  }
}

TEST(Protrusion, ABoxInsideAHull) {
  const Solid solid = solidOf(test_shapes::moved(test_shapes::box(1, 1, 1, 2), {1, 1, 1}));
  expectProtrusion(std::sqrt(3.0), {boxHull({0, 0, 0}, {3, 3, 3})}, solid, 0.001);
  expectProtrusion(1, {boxHull({1, 1, 0}, {2, 2, 2})}, solid, 0.001);
  expectProtrusion(std::sqrt(2.0), {boxHull({1, 0, 0}, {2, 2, 2})}, solid, 0.001);
}

// A search takes cells as small as the plate is thin, all over it, and does not come to its end.
TEST(Protrusion, AThinPlateTakesNoSearch) {
  const TriangleMesh plate = test_shapes::box(1, 1, 0.001, 2);
  const Solid solid = solidOf(plate);
  EXPECT_LE(protrusion({hullOf(plate)}, solid, 1e-5).bound, 1e-5);
  const double e = 5e-9;  // larger by that all around, as by rounding: what is near an edge may be further
  const std::vector<ConvexHull> around{boxHull({-e, -e, -e}, {1 + e, 1 + e, 0.001 + e})};
  const Protrusion p = protrusion(around, solid, {1e-5, 1e-3, 0}, {});
  EXPECT_GE(p.bound, std::sqrt(3) * e);
  EXPECT_LE(p.bound, 2e-5);
}

/// A pyramid on a regular polygon about the z axis, from z = 0 to its tip.
ConvexHull needle(int sides, double radius, double tip) {
  std::vector<Vector3d> points{{0, 0, tip}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * test_shapes::kPi * i / sides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return convexHull(points);
}

/// The same mesh with its tip cut off.
TriangleMesh stump(int sides, double radius, double tip, double cut) {
  test_shapes::MeshBuilder builder;
  const auto at = [&](int i, double z) {
    const double angle = 2 * test_shapes::kPi * (i % sides) / sides, r = radius * (tip - z) / tip;
    return Vector3d(r * std::cos(angle), r * std::sin(angle), z);
  };
  for (int i = 0; i < sides; ++i) {
    builder.quad(at(i, 0), at(i + 1, 0), at(i + 1, tip - cut), at(i, tip - cut));
    builder.triangle(at(i + 1, 0), at(i, 0), {0, 0, 0});
    builder.triangle(at(i, tip - cut), at(i + 1, tip - cut), {0, 0, tip - cut});
  }
  return builder.mesh();
}

// The cut reaches e deep into a needle, and the needle's middle r. Towards the tip both grow with the distance from it, so the tip is e / r
// of its way to the middle from the cut. With its triangles taken away, that is all that bounds the hull: else its surface does.
TEST(Protrusion, WhatTheSurfaceLeavesFreeIsWithinAShareOfTheWayToTheMiddle) {
  for (const double cut : {0.02, 0.1}) {
    const Solid solid = solidOf(stump(16, 1, 20, cut));
    ConvexHull hull = needle(16, 1, 20);
    ASSERT_FALSE(solid.hasOpenings());
    EXPECT_NEAR(solid.distance({0, 0, 20}), cut, 1e-9);
    hull.triangles.clear();
    for (std::size_t i = 0; i < hull.faces.size(); ++i) {  // whichever face is the last
      std::rotate(hull.faces.begin(), hull.faces.begin() + 1, hull.faces.end());
      const double bound = protrusion({hull}, solid, 4 * cut).bound;
      EXPECT_GE(bound, cut);
      EXPECT_LE(bound, 1.1 * cut);
    }
  }
}

/// The points p with n . p <= 1 - `depth` |n| for all n of `planes`: each vertex is the pole of a face of their hull.
std::vector<Vector3d> behind(const std::vector<Vector3d>& planes, double depth) {
  std::vector<Vector3d> poles, result;
  for (const Vector3d& n : planes) poles.push_back(n / (1 - depth * n.norm()));
  for (const HalfSpace& face : convexHull(poles).faces) result.push_back(face.normal / face.offset);
  return result;
}

// What is e deep in a hull is the solid. The hull's triangles are taken away, so that only its faces bound it.
TEST(Protrusion, WhatTheSurfaceLeavesFreeIsWithinTheLongestWayIntoIt) {
  RandomPoints random(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vector3d> planes;
    const Vector3d shape(random.number(0.2, 3), random.number(0.2, 3), random.number(0.2, 3));
    for (int k = 0; k < 12; ++k) planes.push_back(random.onSphere().cwiseProduct(shape));
    if (!holds(convexHull(planes), Vector3d::Zero())) continue;
    double largest = 0;
    for (const Vector3d& n : planes) largest = std::max(largest, n.norm());
    const double e = random.number(0, 0.9) / largest;  // the planes are further than that from the middle
    const ConvexHull inner = convexHull(behind(planes, e));
    ConvexHull hull = convexHull(behind(planes, 0));
    double furthest = 0;
    for (const Vector3d& v : hull.vertices) furthest = std::max(furthest, distance(inner, v));
    hull.triangles.clear();
    EXPECT_GE(protrusion({hull}, solidOf(surface(inner)), 1e3).bound, furthest * (1 - 1e-9));
  }
}

// A share of the way to the middle, which is far, would be 0.4 mm.
TEST(Protrusion, ALongBoardThatTheSurfaceLeavesFree) {
  const double e = 3e-6;
  const Solid solid = solidOf(test_shapes::box(2, 0.4, 0.018));
  ConvexHull hull = boxHull({-e, -e, -e}, {2 + e, 0.4 + e, 0.018 + e});
  hull.triangles.clear();
  const double bound = protrusion({hull}, solid, 4 * e).bound;
  EXPECT_GE(bound, std::sqrt(3) * e);
  EXPECT_LE(bound, 1.001 * std::sqrt(3) * e);
}

// The middle of a rod is outside a block, but so near to it that it seems to be inside; around both, sheets make a summit in the rod.
TEST(Protrusion, AMiddleWithinTheBlurIsNotTakenForInside) {
  constexpr double kSide = 0.3, kHigh = 2, kRod = 1e-3, kAway = 1e-11;
  const auto sheetAt = [](const Vector3d& middle, const Vector3d& u, const Vector3d& v) {
    test_shapes::MeshBuilder builder;
    builder.quad(middle - u - v, middle + u - v, middle + u + v, middle - u + v);
    return builder.mesh();
  };
  std::vector<TriangleMesh> parts{test_shapes::moved(test_shapes::box(0.01, 0.02, 0.02), {kAway, -0.01, -0.01})};
  for (const double side : {-1.0, 1.0}) {
    parts.push_back(sheetAt({side * kSide, 0, 0}, {0, 0.999 * kSide, 0}, {0, 0, 0.999 * kHigh}));
    parts.push_back(sheetAt({0, side * kSide, 0}, {0.999 * kSide, 0, 0}, {0, 0, 0.999 * kHigh}));
    parts.push_back(sheetAt({0, 0, side * kHigh}, {0.999 * kSide, 0, 0}, {0, 0.999 * kSide, 0}));
  }
  const Solid solid = solidOf(test_shapes::merged(parts));
  EXPECT_NEAR(solid.distance({0, 0, 1}), kSide, 1e-12);
  for (const double gap : {3.6e-3, 3.9e-3, 4e-3})
    EXPECT_GE(protrusion({boxHull({-kRod, -kRod, -1.8}, {kRod, kRod, 1.8})}, solid, gap).bound, kSide) << gap;
}

// A blade through a crack meets no surface, and its middle is inside; what stands out of it is not. As below, its triangles are taken away.
TEST(Protrusion, AHullThroughACrackIsNotLeftFree) {
  const Solid solid = solidOf(test_shapes::boxWithSlit(1e-5));
  ASSERT_FALSE(solid.hasOpenings());
  ASSERT_GT(solid.sideError(), 0);
  ASSERT_TRUE(solid.contains({0.5, 0, -0.15}));
  ConvexHull blade = boxHull({0.3, -2e-6, -0.6}, {0.7, 2e-6, 0.3});
  blade.triangles.clear();
  EXPECT_GE(protrusion({blade}, solid, 1e-6).bound, 1.9e-6) << "nearly half its width";
}

// A post through a window meets no surface, and its middle is inside; what stands out of the window is not. Its triangles are taken away so
// that only the search of its inside tells.
TEST(Protrusion, AHullThroughAnOpeningIsNotLeftFree) {
  ConvexHull post = boxHull({0.45, 0.45, 0.2}, {0.55, 0.55, 1.3});
  post.triangles.clear();
  EXPECT_GE(protrusion({post}, solidOf(test_shapes::boxWithWindow(0.2)), 0.001).bound, 0.04) << "nearly half its width";
}

// The middle of a flask's hollow is 1 from its walls, and 0.2 below the surface of a cube, which is 0.8 from them everywhere. The gap is so
// wide that nothing more is looked for.
TEST(Protrusion, NoPointIsDeeperThanHalfTheWidth) {
  const Solid solid = solidOf(test_shapes::flask(0.2, 2));
  const Protrusion p = protrusion({boxHull({-0.2, -0.2, 1.3}, {0.2, 0.2, 1.7})}, solid, 0.38);
  EXPECT_GE(p.bound, 1);
}

// A small octahedron about the middle of a large one of sheets: all of its surface is nearer to these by its radius, which is its depth.
TEST(Protrusion, ASummitMayBeFurtherThanTheSurfaceByAllOfItsDepth) {
  constexpr double kSummit = 0.3, kRadius = 0.01;
  std::vector<Vector3d> corners;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) corners.push_back(sign * std::sqrt(3.0) * kRadius * Vector3d::Unit(axis));
  const Protrusion p = checkedProtrusion({convexHull(corners)}, solidOf(test_shapes::octahedronOfSheets(kSummit)), 1e-4);
  EXPECT_GE(p.bound, kSummit);
}

TEST(Protrusion, AHullApartFromTheSolid) {
  const std::vector<ConvexHull> hulls{boxHull({0, 0, 0}, {1, 1, 1}), boxHull({4, 0, 0}, {5, 1, 1})};
  const Protrusion p = checkedProtrusion(hulls, solidOf(test_shapes::box(1, 1, 1)), 0.001);
  EXPECT_NEAR(p.found, 4, 1e-12);
  EXPECT_EQ(p.hull, 1);
}

TEST(Protrusion, TheBoundIncludesWhatAnOpeningMayHide) {
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  const Protrusion p = protrusion({boxHull({0.3, 0.3, 0.1}, {0.7, 0.7, 0.2})}, solid, 1e-12);
  EXPECT_EQ(p.found, 0);
  EXPECT_GE(p.bound, solid.sideError());
}

TEST(Protrusion, AHollowBehindANarrowNeckIsAnInnerSummit) {
  for (double neck : {0.05, 0.2, 0.4})
    for (int n : {1, 3})
      for (double gap : {0.1, 0.01, 0.002}) {
        SCOPED_TRACE(testing::Message() << neck << ", " << n << ", " << gap);
        const TriangleMesh flask = test_shapes::flask(neck, n);
        const Protrusion p = checkedProtrusion({hullOf(flask)}, solidOf(flask), gap);
        EXPECT_GE(p.bound, 1 - 1e-9);
        EXPECT_LE(p.found, 1 + 1e-9);
        EXPECT_GE(p.found, 1 - gap);
      }
}

TEST(Protrusion, ASummitAtTheHullsOwnCorner) {
  // Hulls that end at the middle of the hollow, which is on their surface or short of it by rounding.
  const Solid solid = solidOf(test_shapes::flask(0.2, 2));
  for (double past : {0.0, 1e-9, 1e-3, 0.01, -1e-9, -0.01}) {
    SCOPED_TRACE(past);
    const ConvexHull spike = convexHull({{-1.5, -1.5, 0}, {-1.5, -1.2, 0}, {-1.2, -1.5, 0}, Vector3d(past, past, 1.5 + past)});
    const Protrusion p = checkedProtrusion({spike}, solid, 0.005);
    EXPECT_GE(p.bound, 1 - std::abs(past) - 1e-9);
    EXPECT_LE(p.found, 1 + 1e-9);
  }
}

TEST(Protrusion, AClosedCavityIsSolid) {
  TriangleMesh cavity = test_shapes::moved(test_shapes::box(0.8, 0.8, 0.8, 2), {0.1, 0.1, 0.1});
  for (Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  const TriangleMesh mesh = test_shapes::merged({test_shapes::box(1, 1, 1, 2), cavity});
  expectProtrusion(0, {hullOf(mesh)}, solidOf(mesh), 0.002);
}

TEST(Protrusion, APartInsideAHousingIsSolid) {
  const TriangleMesh mesh =
      test_shapes::merged({test_shapes::box(1, 1, 1, 2), test_shapes::moved(test_shapes::sphere(0.2, 3), {0.5, 0.5, 0.5})});
  expectProtrusion(0, {hullOf(mesh)}, solidOf(mesh), 0.002);
}

TEST(Protrusion, ABoxAroundASheet) {
  expectProtrusion(0.3, {boxHull({0, 0, -0.2}, {1, 1, 0.3})}, solidOf(test_shapes::sheet(1, 1, 3)), 0.002);
}

TEST(Protrusion, SummitBetweenTwoSheets) {
  const TriangleMesh mesh = test_shapes::merged({test_shapes::sheet(2, 2, 2), test_shapes::moved(test_shapes::sheet(2, 2, 2), {0, 0, 1})});
  expectProtrusion(0.5, {boxHull({0, 0, 0}, {2, 2, 1})}, solidOf(mesh), 0.004);
}

// Many hulls are searched for summits in halves, down to a few.
TEST(Protrusion, ASummitInOneOfManyHulls) {
  for (const std::size_t which : {0, 1, 13, 29, 47}) {
    std::vector<TriangleMesh> parts;
    std::vector<ConvexHull> hulls;
    for (std::size_t i = 0; i < 48; ++i) {
      const Vector3d at(4 * static_cast<double>(i % 8), 4 * static_cast<double>(i / 8), 0);
      parts.push_back(test_shapes::moved(i == which ? test_shapes::flask() : test_shapes::box(1, 1, 1), at));
      hulls.push_back(hullOf(parts.back()));
    }
    const Protrusion p = checkedProtrusion(hulls, solidOf(test_shapes::merged(parts)), 0.01);
    EXPECT_GE(p.bound, 1);
    EXPECT_NEAR(p.found, 1, 0.01);
    EXPECT_EQ(p.hull, static_cast<int>(which));
  }
}

TEST(Protrusion, HullsThatLeaveABoxThroughItsWindow) {
  // The winding number passes 1/2 in the plane of the window: a post through it protrudes by its part above, though its foot lies deeper
  // inside than that.
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  ASSERT_EQ(solid.interior(), Interior::kWinding);
  for (double height : {0.3, 0.1, 0.03}) {
    SCOPED_TRACE(height);
    const Protrusion p = protrusion({boxHull({0.45, 0.45, 0.2}, {0.55, 0.55, 1 + height})}, solid, 0.01);
    EXPECT_GE(p.bound, height);
    expectConsistent(p, {boxHull({0.45, 0.45, 0.2}, {0.55, 0.55, 1 + height})}, solid, 0.01);
  }
}

TEST(Protrusion, AnEdgeAcrossAWindow) {
  // Its ends are near the window's rim; the middles of its two faces lie deep inside, further from the surface than from this edge.
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  const ConvexHull blade = convexHull({{0.32, 0.5, 1.001}, {0.68, 0.5, 1.001}, {0.5, 0.45, 0.2}, {0.5, 0.55, 0.2}});
  RandomPoints random(1);
  const Protrusion p = protrusion({blade}, solid, 0.01);
  double sampled = 0;
  for (int i = 0; i < 2000; ++i)
    sampled = std::max(sampled, solid.distance(random.inTriangle({0.32, 0.5, 1.001}, {0.68, 0.5, 1.001}, {0.5, 0.5, 1.0005})));
  EXPECT_GT(sampled, 0.15);
  EXPECT_LE(sampled, p.bound);
}

// Random input.

/// One shape of each kind, rotated at random.
TriangleMesh anyShape(std::uint32_t seed, RandomPoints& random) {
  const std::vector<TriangleMesh> meshes{test_shapes::torus(0.7, 0.25, 16, 8),
                                         test_shapes::openBox(1, 1, 1, 0.05, 2),
                                         test_shapes::uChannel(1, 1, 0.1, 1, 2),
                                         test_shapes::flange(5, 0.4, 1, 0.12, 0.15, 2, 1),
                                         scaled(test_shapes::flask(0.2, 2), Vector3d::Constant(0.4)),
                                         random.soup(12, 0.5),
                                         test_shapes::sheet(1, 1, 3)};
  Eigen::Isometry3d pose(random.rotation());
  pose.translation() = random.inCube(seed % 2 ? 100 : 0.1);
  return transformed(meshes[seed % meshes.size()], pose);
}

/// Hulls of the shape itself, or of points around it.
std::vector<ConvexHull> anyHulls(std::uint32_t seed, const TriangleMesh& mesh, RandomPoints& random) {
  if (seed % 3 == 0) return {hullOf(mesh)};
  std::vector<ConvexHull> hulls;
  for (int h = 0; h < 4; ++h) {
    std::vector<Vector3d> points;
    for (int i = 0; i < 8; ++i) points.push_back(i % 2 ? random.on(mesh) : random.inBox(boundingBox(mesh)));
    hulls.push_back(convexHull(points));
  }
  return hulls;
}

TEST(Protrusion, DenseSamplesStayBelowTheBound) {
  for (std::uint32_t seed = 0; seed < 42; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const TriangleMesh mesh = anyShape(seed, random);
    const Solid solid = solidOf(mesh);
    const std::vector<ConvexHull> hulls = anyHulls(seed, mesh, random);
    const double gap = diagonal(mesh) * (seed % 2 ? 0.01 : 0.002);
    const Protrusion p = checkedProtrusion(hulls, solid, gap);
    double sampled = 0;
    for (const ConvexHull& hull : hulls)
      for (int i = 0; i < 800; ++i) {
        sampled = std::max(sampled, solid.distance(random.on(surface(hull))));
        sampled = std::max(sampled, solid.distance(inHull(hull, random)));
      }
    EXPECT_LE(sampled, p.bound * (1 + 1e-9));
  }
}

TEST(Protrusion, GrowsWithTheHull) {
  for (std::uint32_t seed = 0; seed < 14; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const TriangleMesh mesh = anyShape(seed, random);
    const Solid solid = solidOf(mesh);
    const double gap = 0.01 * diagonal(mesh);
    std::vector<Vector3d> points;
    for (int i = 0; i < 4; ++i) points.push_back(random.on(mesh));
    double found = 0;
    for (int i = 0; i < 6; ++i) {
      points.push_back(i % 2 ? random.on(mesh) : random.inBox(boundingBox(mesh)));
      const Protrusion p = checkedProtrusion({convexHull(points)}, solid, gap);
      EXPECT_GE(p.bound, found * (1 - 1e-9));
      found = p.found;
    }
  }
}

TEST(Protrusion, IsTheLargestOverTheHullsOfASet) {
  RandomPoints random(3);
  const TriangleMesh mesh = test_shapes::flask(0.2, 2);
  const Solid solid = solidOf(mesh);
  const std::vector<ConvexHull> hulls = anyHulls(1, mesh, random);
  double found = 0, bound = 0;
  for (const ConvexHull& hull : hulls) {
    const Protrusion p = checkedProtrusion({hull}, solid, 0.005);
    found = std::max(found, p.found), bound = std::max(bound, p.bound);
  }
  const Protrusion all = checkedProtrusion(hulls, solid, 0.005);
  EXPECT_LE(all.found, bound);
  EXPECT_LE(found, all.bound);
}

TEST(Protrusion, SameInputGivesSameResult) {
  RandomPoints random(4);
  const TriangleMesh mesh = test_shapes::torus(0.7, 0.25, 16, 8);
  const Solid solid = solidOf(mesh);
  const std::vector<ConvexHull> hulls = anyHulls(1, mesh, random);
  const Protrusion a = protrusion(hulls, solid, 0.002), b = protrusion(hulls, solid, 0.002);
  EXPECT_EQ(a.bound, b.bound);
  EXPECT_EQ(a.found, b.found);
  EXPECT_EQ(a.where, b.where);
  EXPECT_EQ(a.hull, b.hull);
}

/// Many small triangles below one face, which must not be divided along the edges of each.
TEST(Protrusion, ASheetThatIsNotQuiteFlat) {
  RandomPoints random(9);
  TriangleMesh mesh = test_shapes::sheet(1, 1, 40);
  for (Eigen::Vector3d& v : mesh.vertices) v += random.inCube(1e-7);
  const Protrusion p = protrusion({convexHull(mesh.vertices)}, Solid(repair(mesh)), 0.003);
  EXPECT_LE(p.found, 1e-5);
  EXPECT_LE(p.bound, 0.00301);
}

// Whenever time ends, the bound holds: it is only less tight.
TEST(Protrusion, ABoundAfterTheDeadline) {
  const TriangleMesh bowl = test_shapes::openBox();
  const std::vector<ConvexHull> hulls = {hullOf(bowl)};
  const Protrusion exact = protrusion(hulls, solidOf(bowl), 1e-3);
  RunControl late;
  late.deadline = std::chrono::steady_clock::now();
  const Protrusion early = protrusion(hulls, solidOf(bowl), 1e-6, late);
  EXPECT_GE(early.bound, exact.found);
  EXPECT_LE(early.bound, diagonal(bowl));
  EXPECT_GT(early.bound - early.found, 1e-3) << "the search went on";
}

}  // namespace
}  // namespace collision_hulls
