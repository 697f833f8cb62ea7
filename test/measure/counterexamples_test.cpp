// Attempts to refute the certified bound: shapes on which one step of the proof is tight, and a search for points beyond the bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "collision_hulls/measure/measures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;
using test_shapes::inHull;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

Solid pointsAt(const std::vector<Vector3d>& places) {
  TriangleMesh mesh;
  for (const Vector3d& p : places) {
    const int v = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(p);
    mesh.triangles.push_back({v, v, v});
  }
  return solidOf(mesh);
}

// Closed-form answers.

/// From the middle of a needle's side to a place near its tip the distance grows by the whole way, then it falls: the largest is at no
/// corner.
TEST(Counterexamples, TheDistanceGrowsByTheWayFromAPatchsMiddle) {
  const Solid solid = pointsAt({{-1, 0, 0}, {6.8, 0, 0}});
  const ConvexHull needle = convexHull({{3, 0, 0}, {0, 1e-3, 0}, {0, -1e-3, 1e-3}, {0, -1e-3, -1e-3}});
  for (const double gap : {0.05, 0.01}) {
    const Protrusion p = protrusion({needle}, solid, gap);
    EXPECT_GE(p.bound, 3.9);
    EXPECT_LE(p.bound, 3.9 + 2 * gap);
  }
}

/// A cavity that opens only to itself is solid; the middle of one with a hair-thin neck is the only place at that distance.
TEST(Counterexamples, ASummitFarFromTheHullsSurface) {
  const Solid solid = solidOf(test_shapes::flask(0.01, 1));
  const Protrusion p = protrusion({boxHull({-1.4, -1.4, 0.1}, {1.4, 1.4, 2.9})}, solid, 0.01);
  EXPECT_GE(p.bound, 1);
  EXPECT_LE(p.bound, 1.02);
}

/// Two blocks with a slot between them: all of the slot's middle is a summit.
TEST(Counterexamples, ASlotOfConstantWidth) {
  const TriangleMesh block = test_shapes::box(1, 1, 1);
  const Solid solid = solidOf(test_shapes::merged({block, test_shapes::moved(block, {1.2, 0, 0})}));
  const Protrusion p = protrusion({boxHull({0.1, 0.1, 0.1}, {2.1, 0.9, 0.9})}, solid, 0.002);
  EXPECT_GE(p.bound, 0.1);
  EXPECT_LE(p.bound, 0.104);
}

/// A prism whose right lobe is inside out hangs over a plate; the space between the lobe's back and the plate is a pocket for a hull's
/// inside.
TEST(Counterexamples, APocketBeforeABack) {
  const TriangleMesh lobes = test_shapes::prism({{-3, -1}, {2, 2.0 / 3}, {2, 0}, {-3, 0}}, {{0, 1, 2}, {0, 2, 3}}, 1);
  TriangleMesh bowl = test_shapes::squareVessel({{0.8, 0}, {0.8, 1}, {0.5, 1}, {0.3, 0.4}});
  for (Vector3d& v : bowl.vertices) v = {1.2 + v.x(), v.z() - 1.0001, 0.5 - v.y()};  // its mouth, closed by the lobe, faces up
  const Solid solid = solidOf(test_shapes::merged({lobes, bowl}));
  const ConvexHull hull = boxHull({0.41, -0.99, -0.29}, {1.99, 0.02, 1.29});
  double sampled = 0;
  RandomPoints random(1);
  for (int i = 0; i < 20000; ++i) sampled = std::max(sampled, solid.distance(inHull(hull, random)));
  const Protrusion p = protrusion({hull}, solid, 0.001);
  EXPECT_GT(sampled, 0.2);
  EXPECT_GE(p.bound, sampled);
}

TEST(Counterexamples, TheBoundAllowsForRounding) {
  const Protrusion p =
      protrusion({boxHull({-1000, 0, 0}, {1000, 1, 1})}, solidOf(test_shapes::moved(test_shapes::box(2000, 1, 1), {-1000, 0, 0})), 1);
  EXPECT_GE(p.bound - p.found, 1e-9);
  EXPECT_LE(protrusion({boxHull({0, 0, 0}, {1, 1, 1})}, solidOf(test_shapes::box(1, 1, 1)), 1e-9).bound, 5e-9);
}

// The triangles are searched; what lies between them and the faces counts as well.
TEST(Counterexamples, TheBoundAllowsForDentsOfAHull) {
  ConvexHull hull = boxHull({0, 0, 0}, {1, 1, 1});
  const Solid solid = solidOf(test_shapes::box(1, 1, 0.5));
  const double before = protrusion({hull}, solid, 0.01).bound;
  for (HalfSpace& face : hull.faces) face.offset += 1e-4;
  EXPECT_GE(protrusion({hull}, solid, 0.01).bound, before + 1e-4);
  EXPECT_LE(protrusion({hull}, solid, 0.01).bound, before + 1e-3);
}

// Where three faces lie outside the triangles, they meet further out.
TEST(Counterexamples, TheBoundReachesToWhereFacesMeet) {
  const double out = 1e-4;
  ConvexHull hull = boxHull({0, 0, 0}, {1, 1, 1});
  for (HalfSpace& face : hull.faces) face.offset += out;
  const double bound = protrusion({hull}, solidOf(test_shapes::box(1, 1, 1)), 1e-6).bound;
  EXPECT_GE(bound, std::sqrt(3.0) * out);
  EXPECT_LE(bound, 1.02 * std::sqrt(3.0) * out);
}

// What rounding may hide is a share of the mesh's extent, and of the hulls' coordinates: a hull deep inside, and one far from the origin.
TEST(Counterexamples, TheBoundAllowsForTheRoundingOfMeshesAndOfHulls) {
  const double share = 1e-12;
  const Solid large = solidOf(test_shapes::moved(test_shapes::box(2000, 2000, 2000), {-1000, -1000, -1000}));
  EXPECT_GE(protrusion({boxHull({-1, -1, -1}, {1, 1, 1})}, large, 1e-11).bound, share * 2000);
  const Vector3d far(1e6, 0, 0);
  const Solid moved = solidOf(test_shapes::moved(test_shapes::box(1, 1, 1), far));
  EXPECT_GE(protrusion({boxHull(far + Vector3d::Constant(0.25), far + Vector3d::Constant(0.75))}, moved, 1e-11).bound, share * 1e6);
}

// Random input.

/// A lower bound on the distance to S and, near openings, to the part of it that surely is inside.
double distanceAtLeast(const Solid& solid, const Vector3d& p) {
  return solid.contains(p) ? 0 : std::min(solid.distanceToSurface(p), solid.wayToBorder(p));
}

/// The largest distance that samples of a hull and steps uphill from the best of them come upon.
double furthestFound(const ConvexHull& hull, const Solid& solid, RandomPoints& random) {
  constexpr int kSamples = 400, kStarts = 4, kSteps = 120;
  std::vector<std::pair<double, Vector3d>> best;
  const TriangleMesh skin = surface(hull);
  for (int i = 0; i < kSamples; ++i) {
    const Vector3d p = i % 2 ? random.on(skin) : inHull(hull, random);
    best.emplace_back(distanceAtLeast(solid, p), p);
  }
  std::sort(best.begin(), best.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  double found = 0;
  for (std::size_t start = 0; start < kStarts; ++start) {
    auto [height, at] = best[start];
    double stride = 0.1 * boundingBox(hull).diagonal().norm();
    for (int i = 0; i < kSteps; ++i) {
      const Vector3d next = at + stride * random.inCube();
      const double there = planeDistance(hull, next) <= 0 ? distanceAtLeast(solid, next) : -1;
      if (there > height)
        at = next, height = there;
      else
        stride *= 0.95;
    }
    found = std::max(found, height);
  }
  return found;
}

/// Splits each edge of a triangle at a point beside it, which opens cracks along the edges.
TriangleMesh cracked(TriangleMesh mesh, double aside) {
  const Triangle t = mesh.triangles.back();
  mesh.triangles.pop_back();
  const int middle = static_cast<int>(mesh.vertices.size());
  const auto at = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
  mesh.vertices.push_back((at(0) + at(1)) / 2 + Vector3d::Constant(aside));
  mesh.triangles.push_back({t[0], middle, t[2]});
  mesh.triangles.push_back({middle, t[1], t[2]});
  return mesh;
}

/// Closed, open, cracked, crossing itself, inside out in places, and without an inside.
TriangleMesh anySolid(std::uint32_t seed, RandomPoints& random) {
  TriangleMesh crumpled = test_shapes::sphere(1, 4);
  for (Vector3d& v : crumpled.vertices)
    if (v.x() > 0.3) v += random.inCube(0.5);
  const std::vector<TriangleMesh> meshes{test_shapes::flask(random.number(0.05, 0.4), 1),
                                         test_shapes::boxWithWindow(random.number(0.05, 0.25)),
                                         cracked(test_shapes::uChannel(), random.number(-5e-6, 5e-6)),
                                         crumpled,
                                         test_shapes::prism({{-3, -1}, {2, 2.0 / 3}, {2, 0}, {-3, 0}}, {{0, 1, 2}, {0, 2, 3}}, 1),
                                         test_shapes::merged({test_shapes::openBox(), random.soup(5, 0.4)}),
                                         test_shapes::torus(0.7, 0.25, 12, 8),
                                         random.soup(10, 0.6)};
  return transformed(meshes[seed % meshes.size()], Eigen::Isometry3d(random.rotation()));
}

TEST(Counterexamples, NoneAreFound) {
  double closest = 0;
  for (std::uint32_t seed = 0; seed < 96; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const TriangleMesh mesh = anySolid(seed, random);
    const Solid solid = solidOf(mesh);
    std::vector<Vector3d> points;
    for (int i = 0; i < 4 + random.index(5); ++i) points.push_back(i % 2 ? random.on(mesh) : random.inBox(boundingBox(mesh)));
    const ConvexHull hull = seed % 4 ? convexHull(points) : convexHull(mesh.vertices);
    const Protrusion p = protrusion({hull}, solid, diagonal(mesh) * (seed % 3 ? 0.03 : 0.003));
    const double found = furthestFound(hull, solid, random);
    EXPECT_LE(found, p.bound);
    if (p.bound > 0) closest = std::max(closest, found / p.bound);
  }
  EXPECT_GT(closest, 0.98) << "the search comes near the bound";
}

}  // namespace
}  // namespace collision_hulls
