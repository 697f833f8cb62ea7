#include "measure/lids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "collision_hulls/mesh/repair.h"
#include "mesh/edges.h"
#include "random_points.h"
#include "shapes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

/// Without sheets, whatever is open.
RepairedMesh asItIs(TriangleMesh mesh) {
  RepairedMesh result;
  result.sheet.assign(mesh.triangles.size(), 0);
  result.mesh = std::move(mesh);
  return result;
}

Lids lidsFor(const RepairedMesh& mesh) {
  const Edges edges = findEdges(mesh.mesh.triangles, mesh.mesh.vertices.size(), {});
  return lidsOf(mesh.mesh, rimOf(mesh, edges, {}), {});
}

double areaOf(const Lids& lids) {
  return area(TriangleMesh{lids.vertices, lids.of_openings});
}

/// How often the triangles use edges in one direction more than in the other.
int surplus(const RepairedMesh& mesh, const Lids& lids) {
  std::map<std::array<int, 2>, int> uses;
  for (const std::vector<Triangle>* triangles : {&mesh.mesh.triangles, &lids.of_cracks, &lids.of_openings})
    for (const Triangle& t : *triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = t[k], to = t[(k + 1) % 3];
        uses[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
      }
  int sum = 0;
  for (const auto& [edge, use] : uses) sum += std::abs(use);
  return sum;
}

/// A tube about the z axis without ends, of radius 1 and height 2, with n edges around.
TriangleMesh tube(int n) {
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * test_shapes::kPi * i / n;
    for (const double z : {0, 2}) mesh.vertices.push_back({std::cos(angle), std::sin(angle), z});
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % n);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

/// A ball cut along a wavy band of this width, nearly all around it, with n vertices on either side: two fans from the poles.
RepairedMesh ballWithSeam(int n, double width) {
  TriangleMesh mesh;
  const auto at = [](double turn, double height) {
    const double angle = 2 * test_shapes::kPi * turn, z = height + 0.4 * std::sin(3 * angle);
    return Vector3d(std::sqrt(1 - z * z) * Vector3d(std::cos(angle), std::sin(angle), 0) + z * Vector3d(0, 0, 1));
  };
  for (int i = 0; i < n; ++i)
    for (const double side : {-0.5, 0.5}) mesh.vertices.push_back(at(0.9 * i / n, side * width));
  const int south = 2 * n, north = south + 1, last = 2 * (n - 1);  // below the band vertices are even, above it odd
  mesh.vertices.push_back({0, 0, -1}), mesh.vertices.push_back({0, 0, 1});
  for (int low = 0; low < last; low += 2) {
    mesh.triangles.push_back({south, low + 2, low});
    mesh.triangles.push_back({north, low + 1, low + 3});
  }
  // Where the band ends, the ball is whole.
  mesh.triangles.insert(mesh.triangles.end(), {{south, 0, last}, {north, last + 1, 1}, {last, 0, 1}, {last, 1, last + 1}});
  return asItIs(mesh);
}

TEST(Lids, NoneAreNeededWhereNothingIsOpen) {
  const Lids lids = lidsFor(asItIs(test_shapes::box(1, 1, 1)));
  EXPECT_TRUE(lids.vertices.empty() && lids.of_cracks.empty() && lids.of_openings.empty() && lids.rim_of_openings.empty());
}

TEST(Lids, CloseTheSurface) {
  std::vector<RepairedMesh> meshes{asItIs(tube(5)), asItIs(tube(6)), asItIs(tube(7)), asItIs(tube(100)), ballWithSeam(60, 0.01)};
  for (const test_shapes::OpenMesh& open : test_shapes::openMeshes()) meshes.push_back(asItIs(open.mesh));
  RandomPoints random(4);
  for (int i = 0; i < 20; ++i) {  // holes that touch, of all shapes
    TriangleMesh mesh = test_shapes::sphere(1, 8);
    std::vector<Triangle> kept;
    for (const Triangle& t : mesh.triangles)
      if (random.index(4) > 0) kept.push_back(t);
    mesh.triangles = kept;
    meshes.push_back(asItIs(mesh));
  }
  std::size_t openings = 0;
  for (const RepairedMesh& mesh : meshes) {
    const Lids lids = lidsFor(mesh);
    openings += lids.of_openings.size();
    EXPECT_EQ(surplus(mesh, lids), 0);
  }
  EXPECT_GT(openings, 1000u);
}

// The triangles of a cone over all of the rim would reach across the ball.
TEST(Lids, WhatRunsThereAndBackIsZippedUp) {
  for (const double width : {0.02, 0.002}) {
    const Lids lids = lidsFor(ballWithSeam(200, width));
    ASSERT_GT(lids.rim_of_openings.size(), 300u);
    double length = 0;
    for (const auto& [a, b] : lids.rim_of_openings)
      length += (lids.vertices[static_cast<std::size_t>(b)] - lids.vertices[static_cast<std::size_t>(a)]).norm() / 2;
    EXPECT_LT(areaOf(lids), 1.5 * width * length);
  }
}

TEST(Lids, OfARoundOpeningAreHardlyLargerThanIt) {
  const Lids lids = lidsFor(asItIs(tube(500)));
  EXPECT_GT(areaOf(lids), 2 * 3.14);
  EXPECT_LT(areaOf(lids), 2 * 3.14 * 1.1);
  EXPECT_LE(lids.of_openings.size(), 2u * 2 * 500);
}

// Hulls that span an opening lie in its plane.
TEST(Lids, LieOffThePlaneOfAFlatOpening) {
  const Lids lids = lidsFor(asItIs(tube(64)));
  for (const Triangle& t : lids.of_openings) {
    double lowest = 9, highest = -9;
    for (const int v : t) {
      const double z = lids.vertices[static_cast<std::size_t>(v)].z();
      lowest = std::min(lowest, z), highest = std::max(highest, z);
    }
    EXPECT_GT(highest - lowest, 1e-3);
  }
}

TEST(Lids, AGapWithinTheWeldToleranceIsACrack) {
  for (const double width : {4e-6, 4e-5}) {
    TriangleMesh mesh = test_shapes::box(1, 1, 1);
    const Triangle split = mesh.triangles[0];
    const auto [a, b, c] = split;
    const auto at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
    const Vector3d along = (at(b) - at(a)).normalized(), half = (at(a) + at(b)) / 2, to = at(c) - half;
    const int middle = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(half + width * (to - to.dot(along) * along).normalized());
    mesh.triangles[0] = {a, middle, c};
    mesh.triangles.push_back({middle, b, c});
    const RepairedMesh repaired = asItIs(mesh);
    const Lids lids = lidsFor(repaired);
    EXPECT_EQ(surplus(repaired, lids), 0);
    EXPECT_EQ(lids.of_cracks.empty(), width > 1e-5);
    EXPECT_EQ(lids.of_openings.empty(), width < 1e-5);
    EXPECT_NEAR(lids.crack_width, width < 1e-5 ? width : 0, 1e-3 * width);
  }
}

}  // namespace
}  // namespace collision_hulls
