#include "decompose/certified/tidy_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/mesh/repair.h"
#include "mesh/loose_segments.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

constexpr double kFlat = 1e-7;

TriangleMesh welded(const TriangleMesh& mesh) {
  return repair(mesh).mesh;
}

/// Each triangle in four.
TriangleMesh finer(const TriangleMesh& mesh) {
  return welded(subdivided(mesh, 2));
}

/// [m] The furthest that a vertex of one surface is from the other.
double apart(const TriangleMesh& mesh, const TriangleMesh& from) {
  const TriangleBvh surface(from);
  double most = 0;
  for (const Eigen::Vector3d& v : mesh.vertices) most = std::max(most, surface.nearest(v).distance);
  return most;
}

void expectSame(const SurfacePiece& a, const SurfacePiece& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(TidySurface, DoesNotDependOnTheOrderInTheFile) {
  for (TriangleMesh mesh : {torus(), lBracket(1, 0.1, 1, 3), flange()}) {
    const SurfacePiece before = tidied(mesh, kFlat);
    std::mt19937 random(1);
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    std::vector<int> place(mesh.vertices.size());
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<int>(i);
    std::shuffle(place.begin(), place.end(), random);
    TriangleMesh other = mesh;
    for (std::size_t i = 0; i < place.size(); ++i) other.vertices[static_cast<std::size_t>(place[i])] = mesh.vertices[i];
    for (Triangle& t : other.triangles) {
      for (int& v : t) v = place[static_cast<std::size_t>(v)];
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    expectSame(tidied(other, kFlat), before);
  }
}

TEST(TidySurface, FlatFacesAndStraightEdgesLoseTheirVertices) {
  const SurfacePiece plain = tidied(finer(finer(box(1, 2, 3, 3))), kFlat);
  EXPECT_EQ(plain.vertices.size(), 8U);
  EXPECT_EQ(plain.triangles.size(), 12U);
  EXPECT_NEAR(area(plain), 22, 1e-12);
  EXPECT_NEAR(signedVolume(plain), 6, 1e-12);
  const SurfacePiece bracket = tidied(finer(lBracket(1, 0.1, 1, 3)), kFlat);
  EXPECT_EQ(bracket.vertices.size(), 12U);
  EXPECT_NEAR(signedVolume(bracket), signedVolume(lBracket()), 1e-12);
}

TEST(TidySurface, RoundShapesStayAsTheyAre) {
  for (const TriangleMesh& mesh : {torus(), welded(sphere())}) {
    const SurfacePiece same = tidied(mesh, kFlat);
    EXPECT_EQ(same.vertices.size(), mesh.vertices.size());
    EXPECT_EQ(same.triangles.size(), mesh.triangles.size());
    const SurfacePiece plain = tidied(finer(mesh), kFlat);
    EXPECT_EQ(plain.vertices.size(), mesh.vertices.size());
    EXPECT_NEAR(area(plain), area(mesh), 1e-12);
  }
}

TEST(TidySurface, MovesNothingFurtherThanAllowed) {
  const TriangleMesh ball = welded(sphere(1, 12));
  std::size_t before = ball.vertices.size();
  for (const double flat : {0.0003, 0.001, 0.003, 0.01}) {
    const SurfacePiece plain = tidied(ball, flat);
    EXPECT_LE(apart(ball, plain), flat);
    EXPECT_LE(apart(plain, ball), 0);
    EXPECT_LE(plain.vertices.size(), before);
    before = plain.vertices.size();
  }
  EXPECT_LT(before, 0.7 * static_cast<double>(ball.vertices.size()));
}

TEST(TidySurface, EdgesWhereTheSurfaceEndsOrBranchesStay) {
  const SurfacePiece open = tidied(welded(sheet(1, 1, 4)), kFlat);
  EXPECT_EQ(open.vertices.size(), 16U);  // those on its rim
  EXPECT_NEAR(area(open), 1, 1e-12);
  const TriangleMesh both = finer(merged({box(1, 1, 1), moved(box(1, 1, 1), {1, 1, 0})}));  // with one edge in common
  const SurfacePiece plain = tidied(both, kFlat);
  EXPECT_NEAR(signedVolume(plain), 2, 1e-12);
  EXPECT_EQ(plain.vertices.size(), 14U + 1U);  // the middle of that edge
}

TEST(TidySurface, TipsWithoutHeightAreDropped) {
  for (const double height : {0.5, 2.0}) {
    TriangleMesh mesh = welded(box(1, 1, 1));
    const Triangle t = mesh.triangles[0];
    const Eigen::Vector3d a = mesh.corner(0, 0), b = mesh.corner(0, 1), out = (b - a).cross(mesh.corner(0, 2) - a).normalized();
    mesh.vertices.push_back((a + b) / 2 + height * kFlat * out);
    mesh.triangles.push_back({t[0], t[1], 8});
    EXPECT_EQ(tidied(mesh, kFlat).triangles.size(), height < 1 ? 12U : 13U) << height;
  }
}

TEST(TidySurface, SliversAreDropped) {
  TriangleMesh mesh = welded(box(1, 1, 1));
  const Triangle t = mesh.triangles[0];
  const Eigen::Vector3d a = mesh.corner(0, 0), b = mesh.corner(0, 1), c = mesh.corner(0, 2);
  mesh.vertices.push_back((a + b) / 2 + 1e-9 * (c - (a + b) / 2));
  mesh.triangles[0] = {t[0], t[1], 8};
  mesh.triangles.push_back({t[1], t[2], 8});
  mesh.triangles.push_back({t[2], t[0], 8});
  const SurfacePiece plain = tidied(mesh, kFlat);
  EXPECT_EQ(plain.vertices.size(), 8U);
  EXPECT_EQ(plain.triangles.size(), 12U);
  EXPECT_NEAR(signedVolume(plain), 1, 1e-12);
}

TEST(TidySurface, PointsAndSegmentsStay) {
  SurfacePiece surface = welded(box(1, 1, 1));
  addSegment(surface, {Eigen::Vector3d(2, 0, 0), Eigen::Vector3d(3, 0, 0)});
  addSegment(surface, {Eigen::Vector3d(2, 2, 0), Eigen::Vector3d(2, 2, 0)});
  const SurfacePiece same = tidied(surface, 0.1);
  EXPECT_EQ(same.vertices.size(), surface.vertices.size());
  EXPECT_EQ(same.triangles.size(), surface.triangles.size());
}

TEST(TidySurface, CanBeCancelled) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(tidied(torus(1, 0.3, 128, 128), kFlat, control), Error);
}

}  // namespace
}  // namespace collision_hulls
