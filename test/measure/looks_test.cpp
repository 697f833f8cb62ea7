// Every loop of Solid() over all of a mesh looks at the control: a cancel must not wait for the end of any.
#include <gtest/gtest.h>

#include "base/parallel.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/measure/solid.h"
#include "counted_looks.h"
#include "measure/rim.h"
#include "mesh/edges.h"
#include "shapes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

constexpr int kSteps = 300;  // some 180,000 triangles: every loop over them looks several times

RepairedMesh closedMesh() {
  return repair(test_shapes::torus(0.3, 0.1, kSteps, kSteps));
}

std::size_t looksOfEdges(const TriangleMesh& mesh) {
  return looksOf([&](const RunControl& control) { findEdges(mesh.triangles, mesh.vertices.size(), control); });
}

std::size_t looksOfTree(const TriangleMesh& mesh) {
  return looksOf([&](const RunControl& control) { const TriangleBvh tree(mesh, {}, control); });
}

TEST(LooksOfSolid, ATree) {
  const TriangleMesh mesh = closedMesh().mesh;
  const std::size_t t = mesh.triangles.size();
  std::size_t compared = 0;  // each level divides the triangles anew
  for (std::size_t nodes = 1; t / nodes > kItemsBetweenLooks; nodes *= 2) compared += nodes * looksFor(t / nodes - 1);
  constexpr std::size_t kParallel = 4096;  // larger nodes look before they are divided
  EXPECT_GE(looksOfTree(mesh), looksFor(t) + compared + (t / kParallel - 1) + looksFor(t / 4));
}

TEST(LooksOfSolid, AllOfAClosedMesh) {
  const RepairedMesh mesh = closedMesh();
  const std::size_t t = mesh.mesh.triangles.size();
  ASSERT_GT(looksFor(t), 5u);
  const std::size_t looks = looksOf([&](const RunControl& control) { const Solid solid(mesh, control); });
  const std::size_t walls = looksFor(t), rim = looksFor(3 * t), sheets = looksFor(t);
  const std::size_t marks = looksFor(3 * t - 1), meetings = (t + 255) / 256, clusters = looksFor(t);
  EXPECT_GE(looks, 1 + 3 * looksOfEdges(mesh.mesh) + 2 * looksOfTree(mesh.mesh) + walls + rim + sheets + marks + meetings + clusters);
}

TEST(LooksOfSolid, ARimIsSortedAndWalked) {
  RepairedMesh mesh = closedMesh();
  std::vector<Triangle> kept;  // every other triangle, in strips: all edges between them are open
  for (std::size_t i = 0; i < mesh.mesh.triangles.size(); i += 2) kept.push_back(mesh.mesh.triangles[i]);
  mesh.mesh.triangles = kept;
  mesh.sheet.assign(kept.size(), 0);
  const Edges edges = findEdges(kept, mesh.mesh.vertices.size(), {});
  Rim rim;
  const std::size_t found = looksOf([&](const RunControl& control) { rim = rimOf(mesh, edges, control); });
  ASSERT_GT(rim.size(), kept.size());
  EXPECT_GE(found, looksFor(3 * kept.size() + 2 * rim.size() - 1));
  EXPECT_GE(looksOf([&](const RunControl& control) { loopsOf(mesh.mesh.vertices, rim, control); }), looksFor(rim.size()));
}

TEST(LooksOfMeasures, EachSampleOfEachHull) {
  constexpr std::size_t kSamples = 20000;
  const ConvexHull one = test_shapes::boxHull({0, 0, 0}, {1, 1, 1}), other = test_shapes::boxHull({0.5, 0, 0}, {1.5, 1, 1});
  EXPECT_GE(looksOf([&](const RunControl& control) { unionVolume({one, other}, control); }), kSamples / kLargeItemsBetweenLooks - 2);
  const Solid solid(repair(test_shapes::box(1, 1, 1)));
  EXPECT_GE(looksOf([&](const RunControl& control) { coveredShare({one}, solid, control); }), kSamples);
}

TEST(LooksOfMeasures, EachVertexAndStepOfACertificate) {
  const Solid solid(repair(test_shapes::torus(0.3, 0.1, 20, 20)));
  const ConvexHull hull = convexHull(test_shapes::torus(0.3, 0.1, 60, 60).vertices);
  const std::size_t compared = looksFor(hull.faces.size() * hull.vertices.size());  // in leastWidth() and overhang()
  EXPECT_GE(looksOf([&](const RunControl& control) { protrusion({hull}, solid, 0.01, control); }), hull.vertices.size() + 2 * compared);
}

/// On one thread: how far others get until they see the error depends on the machine.
TEST(LooksOfSolid, ACancelIsHeededAtOnceWhereverItComes) {
  const RepairedMesh mesh = closedMesh();
  const auto work = [&](const RunControl& control) { withJobs(1, [&] { const Solid solid(mesh, control); }); };
  const std::size_t all = looksOf(work);
  for (std::size_t at = 1; at <= all; at += all / 40 + 1) {
    EXPECT_EQ(looksAfterCancel(at, work), 1u) << "look " << at << " of " << all;
  }
}

}  // namespace
}  // namespace collision_hulls
