// Each trouble does what its name says, and nothing else.
// Also tests src/bench/stability/defects.cpp.
#include "bench/stability/trouble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/repair.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Kind = TroubleKind;

constexpr std::uint64_t kSeed = 5;

const TriangleMesh& torus() {
  static const TriangleMesh mesh = test_shapes::torus(1, 0.3, 24, 12);
  return mesh;
}

TriangleMesh with(Kind kind, double amount) {
  return troubled(torus(), {kind, amount}, kSeed);
}

RepairCounts counts(const TriangleMesh& mesh) {
  return repair(mesh).counts;
}

/// The corners of each triangle, whatever the order of vertices and triangles: identifies the surface.
std::multiset<std::vector<double>> surfaceOf(const TriangleMesh& mesh) {
  std::multiset<std::vector<double>> result;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    std::vector<std::vector<double>> corners;
    for (int k = 0; k < 3; ++k) corners.push_back({mesh.corner(t, k).x(), mesh.corner(t, k).y(), mesh.corner(t, k).z()});
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::vector<double> all;
    for (const auto& corner : corners) all.insert(all.end(), corner.begin(), corner.end());
    result.insert(all);
  }
  return result;
}

TEST(Trouble, NamesAreReadBack) {
  for (const Trouble& trouble : usualTroubles()) EXPECT_EQ(troubleNamed(name(trouble.kind)), trouble.kind);
  EXPECT_FALSE(troubleNamed("Rotation"));
}

TEST(Trouble, UsualTroublesHaveEveryKindAndStartWithNone) {
  std::set<Kind> kinds;
  for (const Trouble& trouble : usualTroubles()) kinds.insert(trouble.kind);
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(Kind::kNan) + 1);
  EXPECT_EQ(usualTroubles().front().kind, Kind::kNone);
  EXPECT_EQ(fewTroubles().front().kind, Kind::kNone);
}

TEST(Trouble, SameSeedSameMesh) {
  for (const Trouble& trouble : usualTroubles()) {
    if (trouble.kind == Kind::kNan) continue;  // NaN is unequal to itself
    const TriangleMesh a = troubled(torus(), trouble, kSeed), b = troubled(torus(), trouble, kSeed);
    EXPECT_EQ(a.vertices, b.vertices) << name(trouble.kind);
    EXPECT_EQ(a.triangles, b.triangles) << name(trouble.kind);
  }
  EXPECT_NE(with(Kind::kJitter, 1e-3).vertices, troubled(torus(), {Kind::kJitter, 1e-3}, kSeed + 1).vertices);
}

TEST(Trouble, SeedMattersForRandomKindsOnly) {
  for (const Trouble& trouble : usualTroubles()) {
    const bool differs = surfaceOf(troubled(torus(), trouble, 1)) != surfaceOf(troubled(torus(), trouble, 2));
    // A shuffled mesh is the same surface; so is one with another NaN coordinate, as NaN is unequal to itself.
    if (trouble.kind == Kind::kShuffle || trouble.kind == Kind::kNan) continue;
    EXPECT_EQ(differs, isRandom(trouble.kind)) << name(trouble.kind);
  }
}

TEST(Trouble, EveryKindChangesTheMeshAndKeepsItValid) {
  for (const Trouble& trouble : usualTroubles()) {
    const TriangleMesh mesh = troubled(torus(), trouble, kSeed);
    ASSERT_FALSE(mesh.triangles.empty()) << name(trouble.kind);
    for (const Triangle& t : mesh.triangles)
      for (const int corner : t) ASSERT_TRUE(corner >= 0 && corner < static_cast<int>(mesh.vertices.size())) << name(trouble.kind);
    if (trouble.kind != Kind::kNone) {
      EXPECT_TRUE(mesh.vertices != torus().vertices || mesh.triangles != torus().triangles) << name(trouble.kind);
    }
  }
}

TEST(Trouble, SingleTriangleSurvivesEverything) {
  for (const Trouble& trouble : usualTroubles())
    EXPECT_FALSE(troubled(test_shapes::singleTriangle(), trouble, kSeed).triangles.empty()) << name(trouble.kind);
}

TEST(Trouble, RotationKeepsDistances) {
  const TriangleMesh turned = with(Kind::kRotation, 77);
  EXPECT_EQ(turned.triangles, torus().triangles);
  EXPECT_NEAR(area(turned), area(torus()), 1e-12);
  EXPECT_LT((boundingBox(turned).center() - boundingBox(torus()).center()).norm(), 0.3);
  // The cosine of a rotation's angle is half of its trace minus one half.
  Eigen::Matrix3d before, after;
  const Eigen::Vector3d middle = boundingBox(torus()).center();
  for (int k = 0; k < 3; ++k) {
    const std::size_t i = static_cast<std::size_t>(40 * k + 7);
    before.col(k) = torus().vertices[i] - middle;
    after.col(k) = turned.vertices[i] - middle;
  }
  EXPECT_NEAR(((after * before.inverse()).trace() - 1) / 2, std::cos(77 * test_shapes::kPi / 180), 1e-9);
}

TEST(Trouble, JitterMovesEachVertexALittle) {
  const TriangleMesh moved = with(Kind::kJitter, 1e-3);
  const double reach = 1e-3 * diagonal(torus());
  double furthest = 0;
  for (std::size_t i = 0; i < moved.vertices.size(); ++i)
    furthest = std::max(furthest, (moved.vertices[i] - torus().vertices[i]).cwiseAbs().maxCoeff());
  EXPECT_LE(furthest, reach);
  EXPECT_GT(furthest, 0.9 * reach);
}

TEST(Trouble, ScaleAndDistance) {
  EXPECT_NEAR(diagonal(with(Kind::kScale, 1e-3)), 1e-3 * diagonal(torus()), 1e-15);
  EXPECT_EQ(lengthFactor({Kind::kScale, 1e-3}), 1e-3);
  EXPECT_EQ(lengthFactor({Kind::kFar, 10}), 1);
  const TriangleMesh far = with(Kind::kFar, 10);
  EXPECT_NEAR((far.vertices[3] - torus().vertices[3]).norm(), 10 * diagonal(torus()), 1e-9);
}

TEST(Trouble, RetessellationKeepsTheSurface) {
  const TriangleMesh fine = with(Kind::kRetessellation, 4);
  EXPECT_EQ(fine.triangles.size(), 4 * torus().triangles.size());
  EXPECT_EQ(fine.vertices.size(), torus().vertices.size() + torus().triangles.size() * 3 / 2);
  EXPECT_NEAR(area(fine), area(torus()), 1e-12);
  EXPECT_EQ(counts(fine).open_edges, 0u);
}

TEST(Trouble, ShuffleAndUnweldingKeepTheSurface) {
  const TriangleMesh shuffled = with(Kind::kShuffle, 1), unwelded = with(Kind::kUnwelded, 1);
  EXPECT_EQ(surfaceOf(shuffled), surfaceOf(torus()));
  EXPECT_NE(shuffled.vertices, torus().vertices);
  EXPECT_EQ(surfaceOf(unwelded), surfaceOf(torus()));
  EXPECT_EQ(unwelded.vertices.size(), 3 * torus().triangles.size());
}

TEST(Trouble, DuplicateFlippedAndZeroAreaFaces) {
  const auto share = [](std::size_t n) { return static_cast<double>(n) / static_cast<double>(torus().triangles.size()); };
  EXPECT_NEAR(share(counts(with(Kind::kDuplicate, 1.0 / 3)).duplicate), 1.0 / 3, 0.06);
  EXPECT_NEAR(share(counts(with(Kind::kFlipped, 1.0 / 3)).flipped), 1.0 / 3, 0.06);
  EXPECT_NEAR(share(counts(with(Kind::kZeroArea, 0.1)).degenerate), 0.1, 0.04);
}

TEST(Trouble, SliversLieInTheSurface) {
  const TriangleMesh mesh = with(Kind::kSliver, 1e-3);
  EXPECT_NEAR(area(mesh), area(torus()), 1e-9);
  int slivers = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d u = mesh.corner(t, 1) - mesh.corner(t, 0), v = mesh.corner(t, 2) - mesh.corner(t, 0);
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    if (u.cross(v).norm() < 1.1e-3 * longest) ++slivers;
  }
  EXPECT_EQ(static_cast<std::size_t>(slivers), (mesh.triangles.size() - torus().triangles.size()) / 2);
  EXPECT_GT(slivers, 0);
}

TEST(Trouble, HoleIsOnePiece) {
  const TriangleMesh mesh = with(Kind::kHole, 0.1);
  EXPECT_EQ(mesh.triangles.size(), torus().triangles.size() - torus().triangles.size() / 10);
  EXPECT_GT(counts(mesh).open_edges, 0u);
  EXPECT_EQ(counts(mesh).components, 1u);
}

TEST(Trouble, FinsMakeEdgesWithThreeTriangles) {
  EXPECT_GT(counts(with(Kind::kFin, 0.02)).nonmanifold_edges, 0u);
}

TEST(Trouble, CopiesAndSpecksAreComponents) {
  EXPECT_EQ(counts(with(Kind::kSelfCrossing, 0.1)).components, 2u);
  const TriangleMesh nested = with(Kind::kNested, 0.5);
  EXPECT_EQ(counts(nested).components, 2u);
  EXPECT_NEAR(diagonal(nested), diagonal(torus()), 1e-12);
  EXPECT_EQ(counts(with(Kind::kManyComponents, 200)).components, 201u);
}

TEST(Trouble, DecimationAndSingleTriangle) {
  const TriangleMesh coarse = with(Kind::kDecimation, 0.5), one = with(Kind::kOneTriangle, 1);
  EXPECT_LE(coarse.vertices.size(), torus().vertices.size() / 2);
  EXPECT_GT(coarse.vertices.size(), torus().vertices.size() / 8);
  ASSERT_EQ(one.triangles.size(), 1u);
  EXPECT_NEAR(area(one), 2 * test_shapes::kPi * 1.3 / 24 * 2 * 0.3 * std::sin(test_shapes::kPi / 12) / 2, 0.02);
}

TEST(Trouble, NanIsOneCoordinateUsedByATriangle) {
  const TriangleMesh mesh = with(Kind::kNan, 1);
  int count = 0;
  for (const Triangle& t : mesh.triangles)
    for (const int corner : t) count += mesh.vertices[static_cast<std::size_t>(corner)].allFinite() ? 0 : 1;
  EXPECT_EQ(count, 6);  // the triangles around a vertex of the torus
  EXPECT_THROW(repair(mesh), Error);
}

}  // namespace
}  // namespace collision_hulls
