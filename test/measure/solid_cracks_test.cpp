// Solids whose surface has cracks: gaps within the weld tolerance, which are no openings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/measure/solid.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;
using test_shapes::solidOf;
using test_shapes::withoutSummit;

constexpr double kBlur = 1e-9;  // of the extent: how much smaller balls inside are than they might be

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
      EXPECT_NEAR(d, solid.contains(p) && to_surface > kBlur ? -to_surface : to_surface, 6 * std::abs(off) + 2 * kBlur);
      if (d < 0) {  // the ball lies in the cube, of which the lids of the cracks cut off corners no deeper than the cracks are wide
        EXPECT_LE(-d, -beyond + std::abs(off));
        EXPECT_LE(-d, to_surface - 2 * std::abs(off));
        EXPECT_EQ(solid.isOneSide(p, to_surface, -d * 1.01), false);
      }
      const double radius = 0.3;  // a point in reach may be outside, across a crack
      EXPECT_GE(solid.distanceWithin(radius, d, to_surface), solid.distance(p + radius * random.onSphere())) << p.transpose();
    }
  }
  EXPECT_TRUE(Solid(repair(cubeWithCracks(1e-4))).hasOpenings());
}

RepairedMesh turned(RepairedMesh mesh) {
  const Eigen::AngleAxisd turn(0.6, Vector3d(1, 2, 3).normalized());
  for (Vector3d& v : mesh.mesh.vertices) v = turn * v;
  return mesh;
}

TEST(Solid, OfAMovedMeshTakesOverWhatWasProved) {
  const RepairedMesh closed = repair(cubeWithCracks(0));
  const Solid before(closed);
  const std::vector<char>& proved = before.surface().twoSided();
  EXPECT_GT(std::count(proved.begin(), proved.end(), 0), 0);
  EXPECT_EQ(Solid(turned(closed), before).surface().twoSided(), proved);
}

// The largest extent of a cube is smaller when it stands upright, and so are the cracks that it may have.
TEST(Solid, OfAMovedMeshTakesNothingOverIfACrackIsAnOpeningNow) {
  const RepairedMesh upright = repair(cubeWithCracks(8e-6));
  const Solid before(turned(upright)), now(upright, before);
  ASSERT_FALSE(before.hasOpenings());
  ASSERT_TRUE(now.hasOpenings());
  EXPECT_EQ(now.surface().twoSided(), std::vector<char>(upright.mesh.triangles.size(), 1));
}

/// A box with a crack in its side at x = 0: the upper half ends at a point that is `off` above the lower half's edge.
TriangleMesh boxWithCrackedSide(double off) {
  return {{{0, 0, -1}, {0, 0, 0}, {0, 1, 0}, {0, 1, -1}, {0, 0, 1}, {0, 1, 1}, {1, 0, -1}, {1, 0, 1}, {1, 1, 1}, {1, 1, -1}, {0, 0.5, off}},
          {{0, 1, 2},
           {0, 2, 3},
           {4, 5, 2},
           {4, 2, 10},
           {4, 10, 1},
           {6, 7, 4},
           {6, 4, 1},
           {6, 1, 0},
           {9, 3, 2},
           {9, 2, 5},
           {9, 5, 8},
           {6, 9, 8},
           {6, 8, 7},
           {0, 3, 9},
           {0, 9, 6},
           {4, 7, 8},
           {4, 8, 5}}};
}

// The side of a point is told aside of it. Just outside a crack's lid that is inside, while the crack leaves no ball around it.
TEST(Solid, BesideACrackThePointsThatMayBeMisjudgedAreWithinTheSideError) {
  const Solid solid(repair(boxWithCrackedSide(1e-6)));
  ASSERT_FALSE(solid.hasOpenings());
  EXPECT_NEAR(solid.sideError(), 2e-9, 1e-15);  // of an extent of 2
  int misjudged = 0;
  for (const double outside : {0.1, 0.25, 0.5, 0.7}) {  // in blurs, off the lid
    const Vector3d p(-outside * 2e-9, 0.5, 4e-7);
    const double d = solid.signedDistance(p, solid.distanceToSurface(p));
    EXPECT_GE(d + solid.sideError(), outside * 2e-9);
    misjudged += d < outside * 2e-9;
  }
  EXPECT_GT(misjudged, 0);
  EXPECT_EQ(solidOf(test_shapes::box(1, 1, 2)).sideError(), 0);
  EXPECT_GT(solidOf(test_shapes::boxWithWindow(0.2)).sideError(), 0);
}

// A crack's lid faces some way, too.
TEST(Solid, NoSummitIsRuledOutNextToACrack) {
  const Solid solid(repair(cubeWithCracks(5e-6)));
  EXPECT_FALSE(withoutSummit(solid, {0.5, -0.1, 1.1}, 0.01));
  EXPECT_TRUE(withoutSummit(solid, {0.5, 0.5, -0.1}, 0.01));
}

TEST(Solid, TheLeastDistanceAllowsForTheLidsOfCracks) {
  const double off = 5e-6;
  const Solid solid(repair(cubeWithCracks(off)));
  RandomPoints random(3);
  for (int i = 0; i < 500; ++i) {
    const Vector3d p = Vector3d(0.5, 0.5, 0.5) + random.inCube(1);
    const double to_surface = solid.distanceToSurface(p);
    EXPECT_LE(solid.leastDistance(p, to_surface), std::max(0.0, to_surface - 2 * off));
    EXPECT_FALSE(to_surface > 2 * off && solid.isFurther(to_surface - 2 * off, p, to_surface));
  }
}

constexpr double kSlit = 1e-5;  // the least that is no smaller than the weld tolerance allows a crack to be wide

/// A box with its top in z = 0 and a slit along the x axis in it, whose ends lie at `height`, and two corners near them at twice that: from
/// the one to the other runs an edge of the lid, two widths from the sides of the slit.
TriangleMesh boxWithSlit(double height) {
  const double side = 0.1 * kSlit;
  enum { kNear, kStart, kFirst, kSecond, kNearEnd, kEnd, kThird, kFourth, kA, kB, kC, kD, kE, kF, kG, kH };
  return {{{0, 0, 2 * height},
           {-0.01, 0, height},
           {0.02, -side, 0},
           {0.97, -side, 0},
           {1, 0, 2 * height},
           {1.01, 0, height},
           {0.98, side, 0},
           {0.01, side, 0},
           {-1, -1, 0},
           {2, -1, 0},
           {2, 1, 0},
           {-1, 1, 0},
           {-1, -1, -1},
           {2, -1, -1},
           {2, 1, -1},
           {-1, 1, -1}},
          {{kA, kB, kSecond},    {kA, kSecond, kFirst}, {kA, kFirst, kNear},   {kA, kNear, kStart}, {kB, kNearEnd, kSecond},
           {kB, kEnd, kNearEnd}, {kC, kD, kFourth},     {kC, kFourth, kThird}, {kC, kThird, kEnd},  {kD, kStart, kFourth},
           {kD, kA, kStart},     {kB, kC, kEnd},        {kE, kF, kB},          {kE, kB, kA},        {kF, kG, kC},
           {kF, kC, kB},         {kG, kH, kD},          {kG, kD, kC},          {kH, kE, kA},        {kH, kA, kD},
           {kE, kG, kF},         {kE, kH, kG}}};
}

// What hides behind a lid: its middle is two widths nearer than the surface.
TEST(Solid, BallsInsideEndBeforeALidThatIsTwoWidthsFromTheSurface) {
  const Solid solid(repair(boxWithSlit(-kSlit)));
  ASSERT_FALSE(solid.hasOpenings());
  const Vector3d p(0.5, 0, -10 * kSlit);
  const double to_surface = solid.distanceToSurface(p), to_lid = 8 * kSlit;
  EXPECT_TRUE(solid.contains(p + 0.999 * to_lid * Vector3d::UnitZ()));
  EXPECT_FALSE(solid.contains(p + 1.1 * to_lid * Vector3d::UnitZ()));
  EXPECT_LE(-solid.signedDistance(p, to_surface), to_lid);
  EXPECT_LE(-solid.signedDistance(p, to_surface, true), to_lid);
  EXPECT_FALSE(solid.isOneSide(p, to_surface, 1.001 * to_lid));
}

TEST(Solid, TheLeastDistanceIsThatOfALidThatIsTwoWidthsFromTheSurface) {
  const Solid solid(repair(boxWithSlit(kSlit)));
  ASSERT_FALSE(solid.hasOpenings());
  const Vector3d p(0.5, 0, 10 * kSlit);
  const double to_surface = solid.distanceToSurface(p), to_lid = 8 * kSlit;
  EXPECT_LE(solid.leastDistance(p, to_surface), to_lid);
  EXPECT_FALSE(solid.isFurther(1.001 * to_lid, p, to_surface));
}

// A plate above: of the points within the radius, the lowest one is nearest to the lid, which faces the plate.
TEST(Solid, NoSummitIsRuledOutWhereALidIsNearest) {
  const Solid solid(repair(test_shapes::merged({boxWithSlit(kSlit), test_shapes::moved(test_shapes::box(2, 2, 0.5), {-0.5, -1, 0.4})})));
  ASSERT_FALSE(solid.hasOpenings());
  const Vector3d p(0.5, 0, 0.3);
  const double to_surface = solid.distanceToSurface(p), to_lid = p.z() - 2 * kSlit, radius = (to_lid - to_surface) / 2;
  EXPECT_NEAR(to_surface, 0.1, 1e-9);
  EXPECT_FALSE(withoutSummit(solid, p, (1 + 1e-6) * radius));
  EXPECT_TRUE(withoutSummit(solid, p, 0.999 * radius)) << "so that the test can tell";
}

}  // namespace
}  // namespace collision_hulls
