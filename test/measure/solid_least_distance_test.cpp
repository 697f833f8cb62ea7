// Lower bounds on distances from solids.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/measure/solid.h"
#include "measure/lids.h"
#include "measure/rim_field.h"
#include "mesh/edges.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::OpenMesh;
using test_shapes::openMeshes;
using test_shapes::RandomPoints;
using test_shapes::solidOf;

constexpr double kBlur = 1e-9;  // of the extent

double leastDistance(const Solid& solid, const Vector3d& p) {
  return solid.leastDistance(p, solid.distanceToSurface(p));
}

TEST(Solid, TheLeastDistanceOfABoxIsTheDistanceLessTheBlur) {
  const Solid solid = solidOf(test_shapes::box(1, 1, 1));
  RandomPoints random(1);
  for (int i = 0; i < 500; ++i) {
    const Vector3d p = Vector3d(0.5, 0.5, 0.5) + random.inCube(1);
    EXPECT_LE(leastDistance(solid, p), solid.distance(p));
    EXPECT_NEAR(leastDistance(solid, p), solid.distance(p), 3 * kBlur);
    if (solid.distance(p) < 0.01) continue;
    EXPECT_FALSE(solid.isFurther(solid.distance(p) - kBlur, p, solid.distance(p)));
    EXPECT_TRUE(solid.isFurther(solid.distance(p) - 3 * kBlur, p, solid.distance(p)));
  }
  EXPECT_LT(leastDistance(solid, {0.5, 0.5, 1 + kBlur}), kBlur / 2);  // rounding may have moved it there
}

/// Of S, which bulges out of the opening up to where the winding number is 1/2, here just above the window's plane.
TEST(Solid, TheLeastDistanceNeverExceedsThatToAnyPointOfTheSolid) {
  const TriangleMesh mesh = test_shapes::boxWithWindow(0.2);
  const Solid solid = solidOf(mesh);
  const TriangleBvh winding(mesh);
  RandomPoints random(2);
  std::vector<Vector3d> inside;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d p = Vector3d(0.5, 0.5, 1) + random.inCube(0.25);
    if (winding.windingNumber(p) > 0.5 + TriangleBvh::kWindingError) inside.push_back(p);
  }
  ASSERT_GT(inside.size(), 100u);
  double largest = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = Vector3d(0.5, 0.5, 1.05) + random.inCube(0.25);
    const double least = leastDistance(solid, p);
    largest = std::max(largest, least);
    EXPECT_LE(least, solid.distance(p));
    for (const Vector3d& s : inside) ASSERT_LE(least, (p - s).norm()) << p.transpose();
  }
  EXPECT_GT(largest, 0.1);
}

/// A cube without its top, whose lid has many triangles.
TriangleMesh cubeWithoutTop() {
  TriangleMesh cube = test_shapes::box(1, 1, 1, 16);
  const auto isTop = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) { return cube.vertices[static_cast<std::size_t>(v)].z() == 1; });
  };
  cube.triangles.erase(std::remove_if(cube.triangles.begin(), cube.triangles.end(), isTop), cube.triangles.end());
  return cube;
}

// Rough winding numbers are bounded more closely than exact ones, of which nobody knows how they err; so some points are proved to be a
// little further away than their least distance.
TEST(Solid, IsFurtherAgreesWithTheLeastDistance) {
  std::vector<TriangleMesh> meshes{test_shapes::box(1, 1, 1), cubeWithoutTop()};
  for (const OpenMesh& open : openMeshes()) meshes.push_back(open.mesh);
  for (const TriangleMesh& mesh : meshes) {
    const Solid solid = solidOf(mesh);
    RandomPoints random(4);
    int further = 0, short_of_surface = 0;
    for (std::size_t i = 0; i < 4000; ++i) {
      const Vector3d from = i % 2 == 0 ? Vector3d(boundingBox(mesh).center()) : mesh.vertices[i % mesh.vertices.size()];
      const Vector3d p = from + random.inCube(i % 2 == 0 ? 2 : 0.1);
      const double to_surface = solid.distanceToSurface(p), least = solid.leastDistance(p, to_surface);
      for (const double distance : {0.0, 0.5 * least, 0.999 * least, 1.001 * least, 0.3 * to_surface, 0.999 * to_surface}) {
        const bool is_further = solid.isFurther(distance, p, to_surface);
        EXPECT_TRUE(is_further || least <= distance) << least << " " << distance;
        EXPECT_TRUE(!is_further || least > (solid.hasOpenings() ? distance / 1.1 - 0.01 : distance)) << least << " " << distance;
        further += is_further;
      }
      short_of_surface += least > 0 && least < 0.9 * to_surface;
    }
    EXPECT_GT(further, 100);
    EXPECT_EQ(short_of_surface > 10, solid.hasOpenings());
  }
}

/// A tube about the z axis with these rings (see squareVessel()), open at both ends.
TriangleMesh openVessel(const std::vector<Eigen::Vector2d>& rings) {
  TriangleMesh mesh = test_shapes::squareVessel(rings);
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
  mesh.triangles.resize(mesh.triangles.size() - 2);
  return mesh;
}

/// A pillar of width 1 with a window in its top and one in its bottom, of side 0.5. Their lids face away from each other: seen as one
/// cluster from far away, they are nothing.
TriangleMesh pillarWithTwoWindows(double height) {
  return test_shapes::moved(openVessel({{0.25, 0}, {0.5, 0}, {0.5, height}, {0.25, height}}), {0.5, 0.5, 0});
}

RimField fieldOf(const TriangleMesh& mesh) {
  const RepairedMesh repaired = repair(mesh);
  const Rim rim = rimOf(repaired, findEdges(repaired.mesh.triangles, repaired.mesh.vertices.size(), {}), {});
  return RimField(repaired.mesh.vertices, lidsOf(repaired.mesh, rim, {}).rim_of_openings, {});
}

/// [m] How far the field of the windows' rims lets the exact winding number be from 1/2.
double wayToHalf(const TriangleMesh& mesh, const RimField& field, const Vector3d& p) {
  return field.from(p).way(0.5 - test_shapes::winding(mesh, p));
}

TEST(Solid, WhatIsProvedOfDistancesAllowsForTheErrorsOfRoughWindingNumbers) {
  const TriangleMesh mesh = pillarWithTwoWindows(1);
  const Solid solid = solidOf(mesh);
  const RimField field = fieldOf(mesh);
  ASSERT_TRUE(solid.hasOpenings());
  for (double away = 1.25; away < 3; away += 0.01) {
    const Vector3d p(0.5, 0.5, 0.5 + away);
    const double to_surface = solid.distanceToSurface(p);
    EXPECT_NEAR(to_surface, std::hypot(0.25, away - 0.5), 1e-12);  // and to the rim
    const double way = wayToHalf(mesh, field, p);
    ASSERT_LT(way, 0.9 * to_surface);
    EXPECT_FALSE(solid.isFurther(1.002 * way, p, to_surface)) << away;
    EXPECT_TRUE(solid.isFurther(0.9 * way, p, to_surface)) << away;
  }
}

/// From far away on the axis of a pillar with a window at either end, the rough winding number errs by nearly all that it says.
TEST(Solid, NoDistanceIsProvedThatTheExactWindingNumberDoesNotAllow) {
  const TriangleMesh pillar = pillarWithTwoWindows(4);
  const Solid solid = solidOf(pillar);
  const RimField field = fieldOf(pillar);
  for (double away = 60; away < 140; away += 5) {
    const Vector3d p(0.5, 0.5, 4 + away);
    const double to_surface = solid.distanceToSurface(p), way = wayToHalf(pillar, field, p);
    EXPECT_FALSE(solid.isFurther(way, p, to_surface)) << away;
    EXPECT_TRUE(solid.isFurther(way - 1e-6, p, to_surface)) << away;
  }
}

// Tubes that point at a window from all around: seen from there, the rough winding numbers of their lids add up to an error of 0.014.
TEST(Solid, InAnOpeningItsBorderIsThatOfTheExactWindingNumber) {
  constexpr int kTubes = 24;
  std::vector<TriangleMesh> parts{test_shapes::moved(test_shapes::boxWithWindow(0.2), {-0.5, -0.5, -1})};
  for (int i = 0; i < kTubes; ++i) {
    const double z = (i + 0.5) / kTubes, turn = 2.4 * i;
    const Vector3d to(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
    parts.push_back(openVessel({{0.2, 1.6}, {0.2, 2.4}}));
    for (Vector3d& v : parts.back().vertices) v = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to) * v;
  }
  RepairedMesh mesh = repair(test_shapes::merged(parts));
  mesh.sheet.assign(mesh.sheet.size(), 0);  // open as they are, the tubes enclose something
  const Solid solid(mesh);
  RandomPoints random(6);
  for (int i = 0; i < 40; ++i) {
    const Vector3d middle = 0.1 * Vector3d(random.inCube().x(), random.inCube().y(), 0);
    Vector3d in = middle - Vector3d(0, 0, 0.4), out = middle + Vector3d(0, 0, 0.3);
    ASSERT_TRUE(solid.contains(in) && !solid.contains(out));
    for (int halving = 0; halving < 30; ++halving) {
      const Vector3d p = (in + out) / 2;
      (solid.contains(p) ? in : out) = p;
    }
    EXPECT_NEAR(test_shapes::winding(mesh.mesh, in), 0.55, 1e-3) << in.transpose();
  }
}

TEST(Solid, TheLeastDistanceIsNothingWhereTheWindingNumberMayBeAHalf) {
  const TriangleMesh mesh = test_shapes::boxWithWindow(0.2);
  const Solid solid = solidOf(mesh);
  const TriangleBvh winding(mesh);
  int met = 0;
  for (double z = 0.9; z < 1.1; z += 1e-4) {
    const Vector3d p(0.5, 0.5, z);
    const double w = winding.windingNumber(p);
    if (w < 0.492 || w > 0.498) continue;
    EXPECT_EQ(leastDistance(solid, p), 0);
    ++met;
  }
  EXPECT_GT(met, 5);
}

}  // namespace
}  // namespace collision_hulls
