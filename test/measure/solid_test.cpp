#include "collision_hulls/measure/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/measure/measures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

bool withoutSummit(const Solid& solid, const Vector3d& p, double radius) {
  return solid.surface().facesOneWay(p, solid.distanceToSurface(p) + 2 * radius);
}

// Degenerate input.

TEST(Solid, TrianglesWithoutAreaAreTheirCorners) {
  const Solid solid = solidOf({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(solid.volume(), 0);
  EXPECT_FALSE(solid.contains({1, 0, 0}));
  EXPECT_NEAR(solid.distance({2, 3, 4}), 5, 1e-12);
  EXPECT_FALSE(withoutSummit(solid, {1, 1, 1}, 0.1));
}

TEST(Solid, LoosePointsArePartOfTheSurface) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  mesh.vertices.push_back({5, 5, 5});
  mesh.triangles.push_back({8, 8, 8});
  const Solid solid = solidOf(mesh);
  EXPECT_NEAR(solid.distance({5, 5, 6}), 1, 1e-12);
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
}

// Closed-form answers.

TEST(Solid, Box) {
  const Solid solid = solidOf(test_shapes::box(1, 2, 3, 4));
  EXPECT_EQ(solid.interior(), Interior::kClosed);
  EXPECT_NEAR(solid.volume(), 6, 1e-12);
  EXPECT_TRUE(solid.contains({0.5, 1, 1.5}));
  EXPECT_FALSE(solid.contains({1.5, 1, 1.5}));
  EXPECT_EQ(solid.distance({0.5, 1, 1.5}), 0);
  EXPECT_NEAR(solid.distanceToSurface({0.5, 1, 1.5}), 0.5, 1e-12);
  EXPECT_NEAR(solid.distance({4, 6, 1}), 5, 1e-12);
}

TEST(Solid, ABoxInsideOutIsABox) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1, 2);
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  const Solid solid = solidOf(mesh);
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_NEAR(solid.volume(), 1, 1e-12);
}

TEST(Solid, AClosedCavityIsInside) {
  TriangleMesh cavity = test_shapes::moved(test_shapes::box(0.4, 0.4, 0.4), {0.3, 0.3, 0.3});
  for (Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  const Solid solid = solidOf(test_shapes::merged({test_shapes::box(1, 1, 1), cavity}));
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({0.1, 0.1, 0.1}));
  EXPECT_EQ(solid.distance({0.5, 0.5, 0.5}), 0);
}

TEST(Solid, AnOpenVesselIsHollow) {
  const Solid box = solidOf(test_shapes::openBox()), flask = solidOf(test_shapes::flask());
  EXPECT_NEAR(box.volume(), 1 - 0.9 * 0.9 * 0.95, 1e-12);
  EXPECT_NEAR(box.distance({0.5, 0.5, 0.55}), 0.45, 1e-12);
  EXPECT_NEAR(flask.volume(), 27 - 8 - 0.16 * 0.5, 1e-12);
  EXPECT_NEAR(flask.distance({0, 0, 1.5}), 1, 1e-12);
}

TEST(Solid, ASheetHasNoInside) {
  const Solid solid = solidOf(test_shapes::sheet(1, 1, 3));
  EXPECT_EQ(solid.interior(), Interior::kSurface);
  EXPECT_EQ(solid.volume(), 0);
  EXPECT_NEAR(solid.distance({0.5, 0.5, 0.25}), 0.25, 1e-12);
  EXPECT_NEAR(solid.distance({0.5, 0.5, -0.25}), 0.25, 1e-12);
  EXPECT_FALSE(withoutSummit(solid, {0.5, 0.5, 0.25}, 0.01));
}

TEST(Solid, ASmallWindowLeavesAnInside) {
  const Solid solid = solidOf(test_shapes::boxWithWindow(0.2));
  EXPECT_EQ(solid.interior(), Interior::kWinding);
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.95}));
  EXPECT_FALSE(solid.contains({0.5, 0.5, 1.05}));
  EXPECT_FALSE(solid.contains({0.5, 0.5, -0.05}));
}

TEST(Solid, APartitionInsideABoxChangesNothingOutside) {
  // Three triangles meet at the partition's edges: the surface is closed, but counting crossings cannot tell what it encloses.
  for (bool up : {true, false}) {
    TriangleMesh partition = test_shapes::moved(test_shapes::sheet(1, 1, 1), {0, 0, 0.5});
    if (!up)
      for (Triangle& t : partition.triangles) std::swap(t[0], t[1]);
    TriangleMesh walls = test_shapes::squareVessel({{0.5, 0}, {0.5, 0.5}, {0.5, 1}});
    const Solid solid = solidOf(test_shapes::merged({test_shapes::moved(walls, {0.5, 0.5, 0}), partition}));
    EXPECT_FALSE(solid.contains({0.5, 0.5, -0.1}));
    EXPECT_FALSE(solid.contains({0.4, 0.3, 1.1}));
    EXPECT_FALSE(solid.contains({0.4, 0.3, -2}));
    EXPECT_TRUE(solid.contains({0.5, 0.5, 0.1}));
    EXPECT_TRUE(solid.contains({0.5, 0.5, 0.9}));
  }
}

/// Adjacent unit cubes with all of their walls, each cube the mirror image of its neighbours: the same triangles make up both sides of a
/// shared wall.
TriangleMesh cubes(int x, int y) {
  std::vector<TriangleMesh> all;
  for (int i = 0; i < x; ++i)
    for (int j = 0; j < y; ++j) {
      TriangleMesh cube = test_shapes::box(1, 1, 1);
      for (Vector3d& v : cube.vertices) v += Vector3d(i % 2 ? i + 1 - 2 * v.x() : i, j % 2 ? j + 1 - 2 * v.y() : j, 0);
      if ((i + j) % 2)
        for (Triangle& t : cube.triangles) std::swap(t[0], t[1]);
      all.push_back(cube);
    }
  return test_shapes::merged(all);
}

TEST(Solid, WallsSharedBySolidsEncloseNothing) {
  for (const auto& [x, y] : {std::pair(2, 1), std::pair(5, 1), std::pair(2, 2), std::pair(3, 3)}) {
    const Solid solid = solidOf(cubes(x, y));
    EXPECT_FALSE(solid.hasOpenings());
    EXPECT_EQ(solid.interior(), Interior::kClosed);
    EXPECT_NEAR(solid.volume(), x * y, 1e-12);
    for (const double step : {-0.02, 0.02}) EXPECT_TRUE(solid.contains({1 + step, 0.4, 0.6})) << x << " by " << y;
    EXPECT_FALSE(solid.contains({0.5, 0.4, 1.02}));
    EXPECT_LE(protrusion({test_shapes::boxHull({0, 0, 0}, Vector3d(x, y, 1))}, solid, 1e-4).found, 1e-12);
  }
}

TEST(Solid, TrianglesThatAllFaceBothWaysStillEncloseASolid) {
  TriangleMesh mesh = cubes(2, 2);
  const std::size_t triangles = mesh.triangles.size();
  for (std::size_t t = 0; t < triangles; ++t) mesh.triangles.push_back({mesh.triangles[t][0], mesh.triangles[t][2], mesh.triangles[t][1]});
  EXPECT_TRUE(solidOf(mesh).contains({0.5, 0.4, 0.6}));
}

TEST(Solid, TheSignedDistanceStaysInside) {
  for (double half : {0.05, 0.1, 0.2}) {
    const TriangleMesh mesh = test_shapes::boxWithWindow(half);
    const Solid solid = solidOf(mesh);
    ASSERT_TRUE(solid.hasOpenings());
    RandomPoints random(1);
    double largest = 0;
    for (int i = 0; i < 500; ++i) {
      const Vector3d p = random.inBox(boundingBox(mesh));
      const double to_surface = solid.distanceToSurface(p), d = solid.signedDistance(p, to_surface);
      EXPECT_EQ(d > 0, !solid.contains(p) && to_surface > 0);
      EXPECT_LE(-d, to_surface);
      if (d > 0) continue;
      largest = std::max(largest, -d);
      for (int k = 0; k < 20; ++k) EXPECT_TRUE(solid.contains(p - 0.999 * std::min(d, 0.0) * random.onSphere())) << p.transpose();
    }
    EXPECT_GT(largest, 0.15);
  }
  const Solid closed = solidOf(test_shapes::box(1, 1, 1));
  EXPECT_FALSE(closed.hasOpenings());
  EXPECT_EQ(closed.signedDistance({0.5, 0.5, 0.5}, 0.5), -0.5);
  EXPECT_EQ(closed.signedDistance({0.5, 0.5, 1.5}, 0.5), 0.5);
}

/// A cube of side 1 whose top and sides meet at different vertices: each edge of the top is split at a point `off` beside the sides' edge.
TriangleMesh cubeWithCracks(double off) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  TriangleMesh result{mesh.vertices, {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& face = mesh.triangles[t];
    const auto at = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(face[k])]; };
    const bool top = at(0).z() + at(1).z() + at(2).z() == 3;
    std::size_t k = 0;  // the longest side is the diagonal of the top; the side k + 1 to k + 2 is not
    while (top && (at(k) - at((k + 1) % 3)).norm() > 1.1) ++k;
    if (!top) {
      result.triangles.push_back(face);
      continue;
    }
    const int a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3], middle = static_cast<int>(result.vertices.size());
    result.vertices.push_back((at(k) + at((k + 1) % 3)) / 2 + Vector3d(off, off, off));
    result.triangles.push_back({a, middle, c});
    result.triangles.push_back({middle, b, c});
  }
  return result;
}

TEST(Solid, CracksWithinTheWeldToleranceAreNotOpenings) {
  for (const double off : {0.0, 1e-9, -1e-9, 5e-6, -5e-6}) {
    const RepairedMesh repaired = repair(cubeWithCracks(off));
    ASSERT_EQ(repaired.counts.open_edges, 6U);
    const Solid solid(repaired);
    EXPECT_FALSE(solid.hasOpenings());
    RandomPoints random(1);
    for (int i = 0; i < 2000; ++i) {
      const Vector3d p = Vector3d(0.5, 0.5, 0.5) + 1.2 * random.inCube(0.5);
      const double beyond = ((p - Vector3d(0.5, 0.5, 0.5)).cwiseAbs() - Vector3d(0.5, 0.5, 0.5)).maxCoeff();
      if (std::abs(beyond) > 2 * std::abs(off)) {
        EXPECT_EQ(solid.contains(p), beyond < 0) << p.transpose();
      }
      const double to_surface = solid.distanceToSurface(p), d = solid.signedDistance(p, to_surface);
      EXPECT_NEAR(d, solid.contains(p) ? -to_surface : to_surface, 6 * std::abs(off));
      const double radius = 0.3;  // a point in reach may be outside, across a crack
      EXPECT_GE(solid.distanceWithin(radius, d, to_surface), solid.distance(p + radius * random.onSphere())) << p.transpose();
    }
  }
  EXPECT_TRUE(Solid(repair(cubeWithCracks(1e-4))).hasOpenings());
}

TEST(Solid, FinsDoNotAffectTheInside) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  for (int side = 0; side < 2; ++side) {
    const auto y = static_cast<double>(side);
    mesh = test_shapes::merged({mesh, {{{0, y, 1}, {1, y, 1}, {1, y, 1.4}, {0, y, 1.4}}, {{0, 1, 2}, {0, 2, 3}}}});
  }
  const Solid solid = solidOf(mesh);
  EXPECT_FALSE(solid.hasOpenings());
  for (const double z : {0.01, 0.5, 0.99, 0.999})
    for (const double y : {0.001, 0.01, 0.5, 0.99}) EXPECT_TRUE(solid.contains({0.5, y, z}));
  for (const double z : {1.01, 1.2, 1.39})
    for (const double y : {-0.01, 0.01, 0.5, 0.99, 1.01}) EXPECT_FALSE(solid.contains({0.5, y, z}));
  EXPECT_NEAR(solid.distance({0.5, 0.5, 1.3}), 0.3, 1e-12);
  EXPECT_NEAR(solid.distance({0.5, 0.1, 1.3}), 0.1, 1e-12);  // to a fin
  EXPECT_DOUBLE_EQ(solid.volume(), 1);
}

TEST(Solid, NoPathToABorderIsShorterThanTheBound) {
  const TriangleMesh mesh = test_shapes::boxWithWindow(0.2);
  const Solid solid = solidOf(mesh);
  RandomPoints random(1);
  double largest = 0;
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = Vector3d(0.5, 0.5, 1) + random.inCube(0.2);
    const double way = solid.wayToBorder(p);
    const bool inside = solid.contains(p);
    largest = std::max(largest, way);
    for (int k = 0; k < 20; ++k) {  // straight paths through the window: the border separates their ends
      const Vector3d through(0.5 + random.number(-0.2, 0.2), 0.5 + random.number(-0.2, 0.2), 1);
      const Vector3d end = through + random.number(0, 0.5) * (through - p);
      if (solid.contains(end) == inside) continue;
      EXPECT_GE((end - p).norm(), way);
      ++met;
    }
  }
  EXPECT_GT(largest, 0.05);
  EXPECT_GT(met, 1000);
  EXPECT_TRUE(std::isinf(solidOf(test_shapes::box(1, 1, 1)).wayToBorder({0.5, 0.5, 0.5})));
}

TEST(Solid, OverlappingComponentsAreOneSolid) {
  const Solid solid =
      solidOf(test_shapes::merged({test_shapes::box(1, 1, 1), test_shapes::moved(test_shapes::box(1, 1, 1), {0.5, 0.25, 0.25})}));
  EXPECT_TRUE(solid.contains({0.75, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({1.2, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({0.2, 0.5, 0.5}));
  EXPECT_FALSE(solid.contains({1.2, 0.1, 0.1}));
}

TEST(Solid, FarFromTheOriginAndTiny) {
  const Solid far = solidOf(test_shapes::moved(test_shapes::openBox(), {1e6, 1e6, 1e6}));
  EXPECT_NEAR(far.distance(Vector3d(0.5, 0.5, 0.55) + Vector3d::Constant(1e6)), 0.45, 1e-8);
  const Solid tiny = solidOf(scaled(test_shapes::openBox(), Vector3d::Constant(1e-9)));
  EXPECT_NEAR(tiny.distance(1e-9 * Vector3d(0.5, 0.5, 0.55)), 0.45e-9, 1e-20);
}

// Random input.

TEST(Solid, TheDistanceHasNoSummitWhereNoneIsPredicted) {
  // A maximum inside a ball that exceeds all values on the ball's border is a summit.
  int without = 0, with = 0;
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const std::vector<TriangleMesh> meshes{test_shapes::openBox(1, 1, 1, 0.05, 3), test_shapes::torus(0.8, 0.2, 16, 8),
                                           test_shapes::uChannel(1, 1, 0.1, 1, 2)};
    for (const TriangleMesh& mesh : meshes) {
      const Solid solid = solidOf(mesh);
      for (int i = 0; i < 60; ++i) {
        const Vector3d p = random.inBox(boundingBox(mesh));
        const double radius = random.number(0.01, 0.15);
        if (!withoutSummit(solid, p, radius)) {
          ++with;
          continue;
        }
        ++without;
        double within = 0, border = 0;
        for (int k = 0; k < 200; ++k) {
          within = std::max(within, solid.distance(p + radius * random.number(0, 0.5) * random.onSphere()));
          border = std::max(border, solid.distance(p + radius * random.onSphere()));
        }
        EXPECT_LE(within, border) << p.transpose() << ", radius " << radius;
      }
    }
  }
  EXPECT_GT(without, 50);
  EXPECT_GT(with, 20);
}

}  // namespace
}  // namespace collision_hulls
