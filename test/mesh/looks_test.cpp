// Every loop of repair() over all of a mesh looks at the control: a cancel must not wait for the end of any.
#include <gtest/gtest.h>

#include "collision_hulls/mesh/repair.h"
#include "counted_looks.h"
#include "mesh/boundary.h"
#include "mesh/edges.h"
#include "mesh/orient.h"
#include "mesh/sheets/fins.h"
#include "mesh/weld.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

constexpr int kSteps = 300;  // some 180,000 triangles: every loop over them looks several times

TriangleMesh closedMesh() {
  return test_shapes::torus(0.3, 0.1, kSteps, kSteps);
}

/// Triangles that share no vertex.
TriangleMesh apart(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) result.vertices.push_back(mesh.corner(t, k));
    result.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return result;
}

std::size_t looksOfEdges(std::size_t triangles, std::size_t vertices) {
  return looksFor(6 * triangles + vertices) + looksFor(vertices) + looksFor(triangles);
}

TEST(LooksOfRepair, Edges) {
  const TriangleMesh mesh = closedMesh();
  const std::size_t looks = looksOf([&](const RunControl& control) { findEdges(mesh.triangles, mesh.vertices.size(), control); });
  EXPECT_GE(looks, looksOfEdges(mesh.triangles.size(), mesh.vertices.size()));
}

TEST(LooksOfRepair, AllOfAClosedMesh) {
  const TriangleMesh mesh = closedMesh();
  const std::size_t t = mesh.triangles.size(), v = mesh.vertices.size();
  ASSERT_GT(looksFor(t), 5u);
  const std::size_t looks = looksOf([&](const RunControl& control) { repair(mesh, {}, control); });
  const std::size_t check = looksFor(t), weld = looksFor(t + v), kept = looksFor(t), compact = looksFor(6 * t + v);
  const std::size_t orient = looksFor(8 * t), interiors = looksFor(4 * t);
  EXPECT_GE(looks, 1 + check + weld + kept + compact + looksOfEdges(t, v) + orient + interiors);
}

TEST(LooksOfRepair, BoundariesAreSortedAndWalked) {
  const TriangleMesh mesh = apart(closedMesh());
  const std::vector<char> turn(mesh.triangles.size());
  const std::vector<int> surface(mesh.triangles.size());
  std::vector<BoundaryEdge> boundary;
  for (int h = 0; h < static_cast<int>(3 * mesh.triangles.size()); ++h) boundary.push_back(boundaryEdge(mesh, h, turn, surface));
  const auto close = [&](const RunControl& control) { closures(mesh.vertices, boundary, 1, Eigen::Vector3d::Zero(), control); };
  // Two sorts of n edges that are sorted already, n edges that are added up, and n that are walked.
  EXPECT_GE(looksOf(close), 4 * looksFor(boundary.size()));
}

TEST(LooksOfRepair, FinsAndTheirEdges) {
  TriangleMesh mesh = closedMesh();
  const std::size_t whole = mesh.triangles.size();
  const std::vector<Triangle> first = mesh.triangles;
  for (const Triangle& t : first) {  // a flap on every edge
    const int tip = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(1.1 * mesh.vertices[static_cast<std::size_t>(t[0])]);
    mesh.triangles.push_back({t[0], t[1], tip});
  }
  const Edges edges = findEdges(mesh.triangles, mesh.vertices.size(), {});
  ASSERT_GT(edges.nonmanifold, whole / 2);
  const OrientedPatches oriented = orient(mesh, edges, {});
  const std::vector<int> surplus(mesh.triangles.size(), 1);
  const std::size_t looks = looksOf([&](const RunControl& control) { findFins(mesh, edges, oriented, surplus, control); });
  const std::size_t open = edges.open, meeting = 3 * edges.nonmanifold;
  EXPECT_GE(looks, looksFor(3 * mesh.triangles.size() + meeting) + 4 * looksFor(open));
}

TEST(LooksOfRepair, WhatRemainsOfFlatTriangles) {
  TriangleMesh mesh = closedMesh();
  const std::size_t whole = mesh.triangles.size();
  std::vector<Triangle> flat;
  for (const Triangle& t : mesh.triangles) flat.push_back({t[0], t[1], t[1]});
  mesh.triangles.insert(mesh.triangles.end(), flat.begin(), flat.end());
  const std::size_t with = looksOf([&](const RunControl& control) { repair(mesh, {}, control); });
  const std::size_t without = looksOf([&](const RunControl& control) { repair(closedMesh(), {}, control); });
  // Three loops over kept triangles' corners or sides, two over the flat ones', and the sort of sides.
  EXPECT_GE(with, without + looksFor(3 * whole) + looksFor(6 * whole) + looksFor(3 * whole) + looksFor(whole));
}

TEST(LooksOfRepair, ACancelIsHeededAtOnceWhereverItComes) {
  const TriangleMesh mesh = closedMesh();
  const auto work = [&](const RunControl& control) { repair(mesh, {}, control); };
  const std::size_t all = looksOf(work);
  for (std::size_t at = 1; at <= all; at += 7) EXPECT_EQ(looksAfterCancel(at, work), 1u) << "look " << at << " of " << all;
}

}  // namespace
}  // namespace collision_hulls
