// Also tests src/geometry/triangle_bvh_inside.cpp.
#include "collision_hulls/geometry/triangle_bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;
using test_shapes::winding;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distanceTo(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& p) {
  return (closestPoint(a, b, c, p) - p).norm();
}

// TriangleBvh: degenerate input.

TEST(TriangleBvh, EmptyMesh) {
  const TriangleBvh bvh(TriangleMesh{});
  EXPECT_TRUE(bvh.empty());
  EXPECT_EQ(bvh.nearest({0, 0, 0}).distance, kInfinity);
  EXPECT_EQ(bvh.nearest({0, 0, 0}).triangle, -1);
  EXPECT_EQ(bvh.windingNumber({0, 0, 0}), 0);
  EXPECT_EQ(bvh.signedCrossings({0, 0, 0}), 0);
  EXPECT_TRUE(bvh.facesOneWay({0, 0, 0}, 1));
  EXPECT_FALSE(bvh.metBy({Vector3d{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(TriangleBvh, TrianglesWithoutArea) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}};
  for (int i = 0; i < 20; ++i) mesh.triangles.push_back(i % 2 ? Triangle{0, 1, 2} : Triangle{1, 1, 1});
  const TriangleBvh bvh(mesh);
  EXPECT_EQ(bvh.nearest({1.5, 3, 4}).distance, 5);
  EXPECT_EQ(bvh.windingNumber({1, 1, 1}), 0);
  EXPECT_EQ(bvh.signedCrossings({1, 0, -1}), 0);
  EXPECT_FALSE(bvh.facesOneWay({1, 1, 1}, 2));
}

TEST(TriangleBvh, OneTriangleManyTimes) {
  TriangleMesh mesh = test_shapes::singleTriangle();
  mesh.triangles.resize(1000, mesh.triangles[0]);
  const TriangleBvh bvh(mesh);
  EXPECT_DOUBLE_EQ(bvh.nearest({0.25, 0.25, 2}).distance, 2);
  EXPECT_EQ(bvh.signedCrossings({0.25, 0.25, -1}), 1000);
  EXPECT_EQ(bvh.signedCrossings({0.25, 0.25, 1}), 0);
  EXPECT_TRUE(bvh.facesOneWay({0.25, 0.25, 1}, 2));
}

TEST(TriangleBvh, NothingIsNearestToNan) {
  const TriangleBvh bvh(test_shapes::box(1, 1, 1, 3));
  EXPECT_EQ(bvh.nearest(Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())).triangle, -1);
}

// nearest()

double bruteForce(const TriangleMesh& mesh, const Vector3d& p) {
  double least = kInfinity;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    least = std::min(least, distanceTo(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), p));
  return least;
}

TEST(TriangleBvh, NearestAgreesWithBruteForce) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    TriangleMesh mesh = seed % 3 == 0 ? test_shapes::torus(1, 0.3, 20, 10) : random.soup(1 + 40 * static_cast<int>(seed), 0.3);
    if (seed % 4 == 1) mesh = test_shapes::moved(mesh, {1e5, -1e5, 1e5});
    const TriangleBvh bvh(mesh);
    Eigen::AlignedBox3d box = boundingBox(mesh);
    box.extend(box.max() + box.sizes()).extend(box.min() - box.sizes());
    int hint = -1;
    for (int i = 0; i < 200; ++i) {
      const Vector3d p = i % 3 == 0 ? Vector3d(random.on(mesh)) : random.inBox(box);
      const double expected = bruteForce(mesh, p);
      const TriangleBvh::Nearest n = bvh.nearest(p), hinted = bvh.nearest(p, kInfinity, hint);
      EXPECT_EQ(n.distance, expected);
      EXPECT_EQ(hinted.distance, expected);
      EXPECT_EQ((n.point - p).norm(), expected);
      const auto& [a, b, c] = bvh.corners(n.triangle);
      EXPECT_EQ(a, mesh.corner(n.triangle, 0));
      EXPECT_EQ(distanceTo(a, b, c, p), expected);
      EXPECT_EQ(bvh.nearest(p, expected * 0.999).triangle, -1);
      EXPECT_EQ(bvh.nearest(p, expected * 0.999, n.triangle).distance, kInfinity);
      EXPECT_EQ(bvh.nearest(p, expected * 1.001 + 1e-100).distance, expected);
      hint = random.index(mesh.triangles.size());
    }
  }
}

// Inside or outside

TEST(TriangleBvh, WindingNumberWithinAHundredth) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const std::vector<TriangleMesh> meshes{test_shapes::torus(1, 0.3, 24, 12), test_shapes::openBox(1, 1, 1, 0.05, 4),
                                           test_shapes::sheet(1, 1, 12), random.soup(200, 0.2)};
    for (const TriangleMesh& mesh : meshes) {
      const TriangleBvh bvh(mesh);
      for (int i = 0; i < 60; ++i) {
        const Vector3d p = random.inCube(1.5);
        EXPECT_NEAR(bvh.windingNumber(p), winding(mesh, p), TriangleBvh::kWindingError);
        for (const double allowed : {1.0, 0.3, 0.05}) {
          const TriangleBvh::RoughWinding rough = bvh.roughWindingNumber(p, allowed);
          EXPECT_NEAR(rough.number, winding(mesh, p), rough.error + 1e-12);
          EXPECT_LE(rough.error, allowed);
        }
      }
    }
  }
}

TEST(TriangleBvh, WithoutAFarViewAllElseIsTheSame) {
  RandomPoints random(1);
  for (const TriangleMesh& mesh : {test_shapes::torus(1, 0.3, 24, 12), test_shapes::sheet(1, 1, 12), random.soup(200, 0.2)}) {
    const TriangleBvh all(mesh), near(mesh, {}, {}, TriangleBvh::Keeps::kNothing);
    EXPECT_EQ(near.extent(), all.extent());
    for (int i = 0; i < 60; ++i) {
      const Vector3d p = random.inCube(1.5), q = p + random.inCube(0.5), r = p + random.inCube(0.5);
      EXPECT_EQ(near.nearest(p).distance, all.nearest(p).distance);
      EXPECT_EQ(near.signedCrossings(p), all.signedCrossings(p));
      EXPECT_EQ(near.trianglesNear({p.cwiseMin(q), p.cwiseMax(q)}), all.trianglesNear({p.cwiseMin(q), p.cwiseMax(q)}));
      EXPECT_EQ(near.metBy({p, q, r}) == nullptr, all.metBy({p, q, r}) == nullptr);
      EXPECT_NEAR(near.windingNumber(p), winding(mesh, p), 1e-12);
      EXPECT_NEAR(near.roughWindingNumber(p, 0.3).number, winding(mesh, p), 1e-12);
      EXPECT_EQ(near.roughWindingNumber(p, 0.3).error, 0);
      EXPECT_FALSE(near.facesOneWay(p, 9));
    }
  }
  EXPECT_TRUE(TriangleBvh({}, {}, {}, TriangleBvh::Keeps::kNothing).facesOneWay({0, 0, 0}, 1));
}

/// Two stacks of small triangles at x = 1 and x = -1 that face away from each other: their dipoles cancel, and what is left at a distance D
/// on the x axis is nearly the bound, area / (2 pi (D - 1)^3).
TEST(TriangleBvh, TheErrorOfDipolesIsBoundedTightly) {
  TriangleMesh mesh;
  mesh.vertices = {{1, 0.3, 0}, {1, -0.15, 0.26}, {1, -0.15, -0.26}, {-1, 0.3, 0}, {-1, -0.15, 0.26}, {-1, -0.15, -0.26}};
  for (int i = 0; i < 8000; ++i) mesh.triangles.insert(mesh.triangles.end(), {{0, 1, 2}, {3, 5, 4}});
  const TriangleBvh bvh(mesh);
  double worst = 0;
  for (double x = 5; x < 60; x += 0.1)
    for (const Vector3d& p : {Vector3d(x, 0, 0), Vector3d(-x, 0, 0)})
      worst = std::max(worst, std::abs(bvh.windingNumber(p) - winding(mesh, p)));
  EXPECT_LE(worst, TriangleBvh::kWindingError);
  EXPECT_GE(worst, 0.8 * TriangleBvh::kWindingError);
  for (const double x : {3, 10, 300}) {
    const Vector3d p(x, 0, 0);
    const TriangleBvh::RoughWinding rough = bvh.roughWindingNumber(p, 1e6);
    const double share = std::abs(rough.number - winding(mesh, p)) / rough.error;
    EXPECT_LE(share, 1) << x;
    EXPECT_TRUE(x < 100 || share > 0.9) << share;
  }
}

/// Compares at p unless the surface is so near that either answer would do.
void expectCrossings(const TriangleBvh& bvh, const TriangleMesh& mesh, const Vector3d& p) {
  if (bruteForce(mesh, p) <= 2e-9 * diagonal(mesh)) return;
  EXPECT_EQ(bvh.signedCrossings(p), std::lround(winding(mesh, p))) << p.transpose();
}

TEST(TriangleBvh, CrossingsAtPointsThatShareCoordinatesWithTheMesh) {
  // Rays through vertices, along edges and inside faces.
  const std::vector<TriangleMesh> meshes{test_shapes::box(1, 1, 1, 4), test_shapes::openBox(1, 1, 1, 0.25, 4),
                                         test_shapes::uChannel(1, 1, 0.25, 2, 2), test_shapes::flange(6, 0.4, 1, 0.12, 0.15, 2, 1),
                                         test_shapes::sphere(1, 3)};
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    SCOPED_TRACE(m);
    const TriangleMesh& mesh = meshes[m];
    const TriangleBvh bvh(mesh);
    const double low = boundingBox(mesh).min().z(), high = boundingBox(mesh).max().z();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      for (double share : {-0.1, 0.0, 0.25, 0.3, 0.5, 0.9, 1.0, 1.1}) {
        Vector3d p = mesh.vertices[v];
        p.z() = low + share * (high - low);
        expectCrossings(bvh, mesh, p);
        p.head<2>() = (p.head<2>() + mesh.vertices[(v * 7 + 3) % mesh.vertices.size()].head<2>()) / 2;
        expectCrossings(bvh, mesh, p);
      }
  }
}

TEST(TriangleBvh, CrossingsAgreeWithSolidAngles) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    TriangleMesh mesh =
        test_shapes::merged({test_shapes::torus(1, 0.3, 24, 12), test_shapes::moved(test_shapes::sphere(0.5, 3), {0.8, 0, 0})});
    const Eigen::Isometry3d pose(random.rotation());
    mesh = transformed(mesh, pose);
    if (seed % 2) mesh = test_shapes::moved(mesh, {1e4, 1e4, -1e4});
    const TriangleBvh bvh(mesh);
    for (int i = 0; i < 300; ++i) expectCrossings(bvh, mesh, random.inBox(boundingBox(mesh)));
    for (const Vector3d& v : mesh.vertices) expectCrossings(bvh, mesh, v + Vector3d(0, 0, random.number(-0.5, 0.5)));
  }
}

TEST(TriangleBvh, CrossingsOfAnInwardSurfaceAreNegative) {
  TriangleMesh box = test_shapes::box(1, 1, 1, 2);
  for (Triangle& t : box.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(TriangleBvh(box).signedCrossings({0.5, 0.5, 0.5}), -1);
}

// facesOneWay(): it may fall short but never claims too much.

/// Whether some direction makes an acute angle with the normals of all triangles within the radius. If one does, so does the point of the
/// normals' convex hull that is nearest to 0 (Gilbert's method).
bool openHalfSpace(const TriangleMesh& mesh, const Vector3d& p, double radius) {
  std::vector<Vector3d> normals;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Vector3d &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    if (distanceTo(a, b, c, p) <= radius * (1 - 1e-9)) normals.push_back((b - a).cross(c - a).normalized());
  }
  if (normals.empty()) return true;
  Vector3d u = normals[0];
  for (int round = 0; round < 2000; ++round) {
    const Vector3d& worst =
        *std::min_element(normals.begin(), normals.end(), [&](const auto& m, const auto& n) { return u.dot(m) < u.dot(n); });
    if (u.dot(worst) > 0) return true;
    const Vector3d way = worst - u;
    u += way * std::clamp(-u.dot(way) / way.squaredNorm(), 0.0, 1.0);
  }
  return false;
}

/// A triangle of length 1 and about this height, with random directions.
TriangleMesh sliver(double height, RandomPoints& random) {
  const Vector3d a = random.inCube(), along = random.onSphere(), up = along.cross(random.onSphere()).normalized();
  return {{a, a + along, a + 0.4 * along + height * up}, {{0, 1, 2}}};
}

TEST(TriangleBvh, AnExtremeSliverFacesAnyWay) {
  RandomPoints random(1);
  const TriangleMesh thin = sliver(1e-6, random), too_thin = sliver(1e-9, random);
  EXPECT_TRUE(TriangleBvh(thin).facesOneWay(thin.vertices[0], 1));
  EXPECT_FALSE(TriangleBvh(too_thin).facesOneWay(too_thin.vertices[0], 1));
}

TEST(TriangleBvh, FacesOneWayClosedForm) {
  const TriangleBvh box(test_shapes::box(1, 1, 1, 8));
  EXPECT_TRUE(box.facesOneWay({0.5, 0.5, 1.2}, 0.3));   // one face
  EXPECT_TRUE(box.facesOneWay({0.5, 1.1, 1.1}, 0.3));   // two at an edge
  EXPECT_TRUE(box.facesOneWay({1.1, 1.1, 1.1}, 0.3));   // three at a corner
  EXPECT_TRUE(box.facesOneWay({2, 2, 2}, 0.1));         // no triangle
  EXPECT_FALSE(box.facesOneWay({0.5, 0.5, 0.5}, 0.6));  // opposite faces
  const TriangleBvh channel(test_shapes::uChannel(1, 1, 0.1, 2, 6));
  EXPECT_TRUE(channel.facesOneWay({0.2, 0.5, 1}, 0.15));
  EXPECT_FALSE(channel.facesOneWay({0.5, 0.5, 1}, 0.45));
}

/// Two arcs of many triangles, 10 apart, whose normals make angles from `least` to `most` degrees with z, on either side of it.
TriangleMesh arcs(double least, double most) {
  constexpr int kPieces = 32;
  test_shapes::MeshBuilder builder;
  for (const double side : {-1.0, 1.0}) {
    const auto at = [&](int i, double y) {
      const double angle = (least + (most - least) * i / kPieces) * test_shapes::kPi / 180;
      return Vector3d(side * (5 + std::sin(angle)), side * y, std::cos(angle));
    };
    for (int i = 0; i < kPieces; ++i) builder.quad(at(i, 0), at(i + 1, 0), at(i + 1, 0.1), at(i, 0.1));
  }
  return builder.mesh();
}

// Whole nodes of the tree stand for their triangles by a cone about their normals.
TEST(TriangleBvh, ConesOfNormalsAreAsWideAsTheirNormals) {
  EXPECT_TRUE(openHalfSpace(arcs(65, 85), {0, 0, 0}, 20));
  EXPECT_TRUE(TriangleBvh(arcs(65, 85)).facesOneWay({0, 0, 0}, 20));
  EXPECT_FALSE(openHalfSpace(arcs(75, 95), {0, 0, 0}, 20));
  EXPECT_FALSE(TriangleBvh(arcs(75, 95)).facesOneWay({0, 0, 0}, 20));
}

TEST(TriangleBvh, TwoSidedTrianglesDoNotFaceOneWay) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 4);
  EXPECT_TRUE(TriangleBvh(sheet).facesOneWay({0.5, 0.5, 0.1}, 0.2));
  std::vector<char> two_sided(sheet.triangles.size(), 0);
  const TriangleBvh one(sheet, two_sided);
  two_sided[static_cast<std::size_t>(one.nearest({0.9, 0.9, 0.1}).triangle)] = 1;
  const TriangleBvh bvh(sheet, two_sided);
  EXPECT_FALSE(bvh.facesOneWay({0.9, 0.9, 0.1}, 0.2));
  EXPECT_TRUE(bvh.facesOneWay({0.1, 0.1, 0.1}, 0.2));
}

TEST(TriangleBvh, FacesOneWayNeverClaimsTooMuch) {
  int claimed = 0, refuted = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const std::vector<TriangleMesh> meshes{test_shapes::torus(1, 0.3, 16, 10), test_shapes::openBox(1, 1, 1, 0.1, 3), random.soup(60, 0.4),
                                           test_shapes::sphere(1, 4)};
    for (const TriangleMesh& mesh : meshes) {
      const TriangleBvh bvh(mesh);
      for (int i = 0; i < 60; ++i) {
        const Vector3d p = random.inCube(1.3);
        const double radius = bvh.nearest(p).distance + random.number(0, 0.5);
        const bool so = openHalfSpace(mesh, p, radius);
        if (bvh.facesOneWay(p, radius)) {
          ++claimed;
          EXPECT_TRUE(so) << p.transpose() << ", radius " << radius;
        }
        refuted += !so;
      }
    }
  }
  EXPECT_GT(claimed, 100);
  EXPECT_GT(refuted, 100);
}

TEST(TriangleBvh, TrianglesNearABoxAreThoseWhoseBoxesMeetIt) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 40, 20);
  const TriangleBvh bvh(mesh);
  RandomPoints random(5);
  for (int i = 0; i < 200; ++i) {
    const Vector3d centre = 1.5 * random.onSphere(), half = Vector3d::Constant(0.3 * std::abs(random.number()));
    const Eigen::AlignedBox3d box(centre - half, centre + half);
    std::vector<int> expected;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      Eigen::AlignedBox3d own;
      for (int k = 0; k < 3; ++k) own.extend(mesh.corner(t, k));
      if (own.intersects(box)) expected.push_back(t);
    }
    EXPECT_EQ(bvh.trianglesNear(box), expected);
  }
  EXPECT_TRUE(TriangleBvh(TriangleMesh{}).trianglesNear({Vector3d::Zero(), Vector3d::Ones()}).empty());
}

// More triangles than one thread builds.
TEST(TriangleBvh, LargeMeshesHaveTheSameNearestPointsAsBruteForce) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 150, 75);
  const TriangleBvh bvh(mesh);
  RandomPoints random(6);
  for (int i = 0; i < 50; ++i) {
    const Vector3d p = 1.5 * random.onSphere() * std::abs(random.number());
    double least = kInfinity;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      least = std::min(least, distanceTo(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), p));
    const TriangleBvh::Nearest nearest = bvh.nearest(p);
    EXPECT_DOUBLE_EQ(nearest.distance, least);
    const auto& [a, b, c] = bvh.corners(nearest.triangle);
    EXPECT_DOUBLE_EQ(distanceTo(a, b, c, p), least);
  }
}

TEST(TriangleBvh, HeightsNextToNothingAreNotDivided) {
  TriangleMesh sheet = test_shapes::sheet(6, 6, 6);
  for (std::size_t i = 0; i < sheet.vertices.size(); ++i) sheet.vertices[i].z() = 1e-40 * static_cast<double>(i % 5);
  const TriangleBvh bvh(sheet);
  EXPECT_EQ(bvh.nearest({3, 3, 2}).distance, 2);
}

}  // namespace
}  // namespace collision_hulls
