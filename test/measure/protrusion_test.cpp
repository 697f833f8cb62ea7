#include "measure/protrusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

TEST(Protrusion, NeedsAGap) {
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  for (const double gap : {0.0, -1.0, std::nan("")}) EXPECT_THROW(protrusion({hullOf(box)}, solidOf(box), gap), Error);
}

// As other programs give them: vertices and triangles alone.
TEST(Protrusion, RefusesAHullWithoutFaces) {
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  ConvexHull hull = hullOf(box);
  hull.faces.clear();
  EXPECT_THROW(protrusion({hull}, solidOf(box), 0.01), Error);
}

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

TEST(Protrusion, ADeadlineThatIsFarLoosensNothing) {
  RunControl far;
  far.deadline = std::chrono::steady_clock::now() + std::chrono::hours(1);
  const TriangleMesh flask = test_shapes::flask(), bowl = test_shapes::openBox();
  for (const TriangleMesh& mesh : {flask, bowl}) {
    const std::vector<ConvexHull> hulls = {hullOf(mesh)};
    const Protrusion free = protrusion(hulls, solidOf(mesh), 1e-3), timed = protrusion(hulls, solidOf(mesh), 1e-3, far);
    EXPECT_LE(timed.bound, free.bound);
    EXPECT_GE(timed.bound, free.found);
    EXPECT_GE(timed.found, free.found - 1e-3);
  }
}

}  // namespace
}  // namespace collision_hulls
