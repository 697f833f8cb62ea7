#include "mesh/seams.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/repair.h"
#include "shapes.h"
#include "soup.h"

namespace collision_hulls {
namespace {

constexpr double kTolerance = 1e-4;

std::optional<Welding> weldSeams(const TriangleMesh& mesh) {
  const Welding welding = weld(mesh, 0, {});
  return weldSeams(mesh, mesh.triangles, findEdges(mesh.triangles, mesh.vertices.size(), {}), kTolerance, welding, {});
}

/// Two triangles with a common side of this length along x, but that the second one's is moved by `gap` in y.
TriangleMesh twoTriangles(double length, double gap) {
  return {{{0, 0, 0}, {length, 0, 0}, {0, -1, 0}, {length, gap, 0}, {0, gap, 0}, {0, 1, 0}}, {{1, 0, 2}, {4, 3, 5}}};
}

TEST(Seams, EndsOfEdgesWithinTheTolerance) {
  const std::optional<Welding> welding = weldSeams(twoTriangles(1, 0.99 * kTolerance));
  ASSERT_TRUE(welding);
  EXPECT_EQ(welding->representative, (std::vector<int>{0, 1, 2, 1, 0, 5}));
  EXPECT_EQ(welding->joined, 2U);
  EXPECT_DOUBLE_EQ(welding->distance, 0.99 * kTolerance);
  EXPECT_FALSE(weldSeams(twoTriangles(1, 1.01 * kTolerance)));
}

TEST(Seams, NotWhereOneEndHasNoPartner) {
  TriangleMesh mesh = twoTriangles(1, 0.5 * kTolerance);
  mesh.vertices[3].y() = 1.4 * kTolerance;  // the middles are still near
  EXPECT_FALSE(weldSeams(mesh));
}

TEST(Seams, NotWhereEdgesRunInTheSameDirection) {
  TriangleMesh mesh = twoTriangles(1, 0.5 * kTolerance);
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  EXPECT_FALSE(weldSeams(mesh));
}

TEST(Seams, NotShortEdgesWhoseEndsMayBeTakenForEachOther) {
  EXPECT_FALSE(weldSeams(twoTriangles(1.9 * kTolerance, 0.5 * kTolerance)));
  EXPECT_TRUE(weldSeams(twoTriangles(2.1 * kTolerance, 0.5 * kTolerance)));
}

TEST(Seams, AChainOfEdgesDoesNotCollapse) {
  const std::vector<double> places{0, 0.95, 1.85, 2.7};  // in tolerances: each has the next as its partner
  for (const std::size_t count : {3, 4}) {
    TriangleMesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
      const int first = static_cast<int>(mesh.vertices.size());
      const double y = kTolerance * places[i], side = i % 2 ? 1 : 0;
      mesh.vertices.insert(mesh.vertices.end(), {{side, y, 0}, {1 - side, y, 0}, {0.5, y, 1.0 + static_cast<double>(i)}});
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    const std::optional<Welding> welding = weldSeams(mesh);
    ASSERT_EQ(welding.has_value(), count == 3);
    if (count == 3) {
      EXPECT_NEAR(welding->distance, 1.85 * kTolerance, 1e-12);
    }
  }
}

TEST(Seams, PiecesOfASurfaceBecomeASolid) {
  // Welding alone joins all copies of a corner, a part of them, or none.
  const TriangleMesh ball = test_shapes::sphere(1, 16);
  for (const double jitter : {1e-6, 4e-6, 8e-6, 1e-5, 2e-5, 4e-5}) {
    const RepairedMesh repaired = repair(soup(ball, jitter, 1));
    EXPECT_EQ(repaired.counts.components, 1U) << jitter;
    EXPECT_EQ(repaired.counts.open_edges, 0U) << jitter;
    EXPECT_EQ(repaired.mesh.triangles.size(), ball.triangles.size()) << jitter;
    EXPECT_NEAR(Solid(repaired).volume(), signedVolume(ball), 5 * jitter) << jitter;
    EXPECT_LE(repaired.counts.weld_distance, 2 * std::sqrt(3.0) * jitter) << jitter;
    EXPECT_GE(repaired.counts.weld_distance, jitter) << jitter;
  }
}

TEST(Seams, EndsMeetBecauseOthersHaveMet) {
  EXPECT_EQ(repair(soup(test_shapes::sphere(1, 8), 8e-5, 1)).counts.open_edges, 0U);  // after one round, 8 are open
}

TEST(Seams, FacetsThatLieFurtherApartHaveAnInsideUnlessTheyAreVeryMany) {
  const TriangleMesh few = test_shapes::sphere(1, 7), many = test_shapes::sphere(1, 8);
  EXPECT_LT(few.triangles.size(), 1000U);
  EXPECT_EQ(interiorOf(repair(soup(few, 5e-4, 1))), Interior::kWinding);
  EXPECT_GT(many.triangles.size(), 1000U);
  EXPECT_EQ(interiorOf(repair(soup(many, 5e-4, 1))), Interior::kSurface);
}

TEST(Seams, NotForAFewOfManyOpenEdges) {
  // Two plates beside each other. Their outer edges stay open, so nothing is moved.
  const RepairedMesh repaired =
      repair(test_shapes::merged({test_shapes::sheet(), test_shapes::moved(test_shapes::sheet(), {1 + 5e-5, 0, 0})}));
  EXPECT_EQ(repaired.counts.components, 2U);
  EXPECT_EQ(repaired.counts.weld_distance, 0);
}

}  // namespace
}  // namespace collision_hulls
