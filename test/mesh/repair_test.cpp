// Also tests src/mesh/sheets/fins.cpp, src/mesh/slits.cpp and src/mesh/weld.cpp.
#include "collision_hulls/mesh/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "collision_hulls/error.h"
#include "mesh/weld.h"
#include "shapes.h"
#include "soup.h"

namespace collision_hulls {
namespace {

using test_shapes::box;
using test_shapes::merged;
using test_shapes::moved;

TriangleMesh inward(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Flips triangles at random.
TriangleMesh scrambled(TriangleMesh mesh, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution turn(share);
  for (Triangle& t : mesh.triangles)
    if (turn(random)) std::swap(t[1], t[2]);
  return mesh;
}

/// No two triangles of a component run along an edge in the same direction; for manifold meshes only.
void expectConsistent(const RepairedMesh& repaired) {
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : repaired.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(edges.insert({t[k], t[(k + 1) % 3]}).second);
}

void expectClosed(const RepairedMesh& repaired, double volume, std::size_t components = 1) {
  EXPECT_EQ(components, repaired.counts.components);
  EXPECT_EQ(0u, repaired.counts.open_edges);
  EXPECT_EQ(Interior::kClosed, interiorOf(repaired));
  EXPECT_NEAR(volume, signedVolume(repaired.mesh), 1e-4 * volume);
}

// --- Nothing, or next to nothing ---

TEST(Repair, MeshWithoutTriangles) {
  const RepairedMesh repaired = repair({{{1, 2, 3}}, {}});
  EXPECT_TRUE(repaired.mesh.vertices.empty());
  EXPECT_TRUE(repaired.mesh.triangles.empty());
  EXPECT_EQ(0u, repaired.counts.components);
  EXPECT_EQ(Interior::kSurface, interiorOf(repaired));
}

TEST(Repair, OneTriangle) {
  const RepairedMesh repaired = repair(test_shapes::singleTriangle());
  EXPECT_EQ(1u, repaired.mesh.triangles.size());
  EXPECT_EQ(3u, repaired.counts.open_edges);
  EXPECT_EQ(std::vector<Interior>{Interior::kSurface}, repaired.interior);
}

TEST(Repair, OnlyDegenerateTrianglesLeaveTheirLongestSides) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 5, 5}}, {{0, 1, 2}, {3, 3, 3}, {1, 1, 0}}};
  const RepairedMesh repaired = repair(mesh);
  EXPECT_TRUE(repaired.mesh.triangles.empty());
  EXPECT_TRUE(repaired.mesh.vertices.empty());
  EXPECT_EQ(3u, repaired.counts.degenerate);
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(3, 0, 0), d(5, 5, 5);
  EXPECT_EQ((std::vector<Segment>{{a, b}, {a, c}, {d, d}}), repaired.loose);
}

TEST(Repair, MeshInOnePoint) {
  const RepairedMesh repaired = repair({{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}, {{0, 1, 2}}});
  EXPECT_EQ(2u, repaired.counts.welded);
  EXPECT_EQ(test_shapes::loosePoints({{7, 7, 7}}), repaired.loose);
}

TEST(Repair, SidesOfKeptTrianglesAreNotLoose) {
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, -1, 0}, {0.5, 0, 0}};
  const auto loose = [&](const std::vector<Triangle>& triangles) { return repair({vertices, triangles}).loose; };
  EXPECT_EQ((std::vector<Segment>{{vertices[0], vertices[3]}}), loose({{0, 1, 2}, {0, 1, 3}}));  // reaches beyond
  EXPECT_TRUE(loose({{0, 1, 2}, {0, 1, 5}}).empty());             // its longest side is that of a kept triangle
  EXPECT_TRUE(loose({{0, 1, 2}, {1, 3, 4}, {0, 3, 1}}).empty());  // its two other sides are
  EXPECT_TRUE(loose({{0, 1, 2}, {2, 2, 2}}).empty());
}

// --- Rejected input ---

ErrorCode codeOf(const TriangleMesh& mesh, const RepairOptions& options = {}) {
  try {
    repair(mesh, options);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::kInternal;
}

TEST(RepairError, IndexOutOfRange) {
  EXPECT_EQ(ErrorCode::kIndexOutOfRange, codeOf({{{0, 0, 0}}, {{0, 0, 1}}}));
  EXPECT_EQ(ErrorCode::kIndexOutOfRange, codeOf({{{0, 0, 0}}, {{0, 0, -1}}}));
}

TEST(RepairError, NonFiniteCoordinate) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ErrorCode::kNonFiniteCoordinate, codeOf({{{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, {{0, 1, 2}}}));
}

TEST(RepairError, WeldToleranceOutOfRange) {
  for (const double tolerance : {-1e-9, 0.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(ErrorCode::kBadOption, codeOf(box(1, 1, 1), {tolerance}));
}

// --- Welding ---

TEST(RepairWeld, SoupBecomesClosed) {
  const RepairedMesh repaired = repair(soup(box(1, 2, 3), 0, 1));
  EXPECT_EQ(8u, repaired.mesh.vertices.size());
  EXPECT_EQ(28u, repaired.counts.welded);
  EXPECT_EQ(0, repaired.counts.weld_distance);
  expectClosed(repaired, 6);
}

TEST(RepairWeld, JitteredSoupBecomesClosedWithinTheTolerance) {
  const TriangleMesh torus = test_shapes::torus();
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const RepairedMesh repaired = repair(soup(torus, 2e-6, seed));
    EXPECT_EQ(torus.vertices.size(), repaired.mesh.vertices.size()) << "seed " << seed;
    expectClosed(repaired, signedVolume(torus));
    EXPECT_GT(repaired.counts.weld_distance, 2e-6);
    EXPECT_LE(repaired.counts.weld_distance, 1e-5 * 2.6);
  }
}

TEST(RepairWeld, DoesNotDependOnRotation) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const TriangleMesh ball = soup(test_shapes::sphere(1, 8), 2e-6, 1);
  const RepairedMesh straight = repair(ball);
  for (int i = 0; i < 10; ++i) {
    TriangleMesh turned = ball;
    const Eigen::Quaterniond q = Eigen::Quaterniond(uniform(random), uniform(random), uniform(random), uniform(random)).normalized();
    for (Eigen::Vector3d& v : turned.vertices) v = q * v;
    EXPECT_EQ(straight.mesh.triangles, repair(turned).mesh.triangles);
  }
}

TEST(RepairWeld, AChainOfCloseVerticesDoesNotCollapse) {
  // 1000 vertices, each within the tolerance of the next, spread over 90 times the tolerance.
  TriangleMesh mesh;
  for (int i = 0; i < 1000; ++i) mesh.vertices.emplace_back(9e-7 * i, 0, 0);
  mesh.vertices.emplace_back(0, 1, 0);
  for (int i = 0; i + 1 < 1000; ++i) mesh.triangles.push_back({i, i + 1, 1000});
  const RepairedMesh repaired = repair(mesh);
  EXPECT_LE(repaired.counts.weld_distance, 1e-5);
  EXPECT_GE(repaired.mesh.vertices.size(), 1 + 45u);
  EXPECT_EQ(mesh.vertices[0], repaired.mesh.vertices[0]) << "the lowest index represents its neighbours";
}

TEST(RepairWeld, ToleranceOfZeroWeldsOnlyEqualVertices) {
  TriangleMesh mesh = soup(box(1, 1, 1), 0, 1);
  mesh.vertices[0].x() += 1e-12;
  EXPECT_EQ(27u, repair(mesh, {0.0}).counts.welded);
  EXPECT_EQ(28u, repair(mesh).counts.welded);
}

TEST(RepairWeld, SizesWhoseSquaresVanishAreOnePoint) {  // sanitizers see it if a vertex lies in a cell that is not a number
  const Welding welding = weld({{{0, 0, 0}, {1e-310, 0, 0}, {0, 1e-310, 0}}, {{0, 1, 2}}}, 0, {});
  EXPECT_EQ(welding.joined, 2u);
}

TEST(RepairWeld, FarFromTheOrigin) {
  expectClosed(repair(soup(moved(test_shapes::torus(), {1e6, -1e6, 1e6}), 0, 1)), signedVolume(test_shapes::torus()));
}

// --- Duplicates ---

TEST(RepairDuplicate, EitherOrderAndAnyFirstCorner) {
  TriangleMesh mesh = box(1, 1, 1);
  const Triangle t = mesh.triangles[3];
  mesh.triangles.push_back(t);
  mesh.triangles.push_back({t[1], t[2], t[0]});
  mesh.triangles.push_back({t[1], t[0], t[2]});
  const RepairedMesh repaired = repair(mesh);
  EXPECT_EQ(3u, repaired.counts.duplicate);
  expectClosed(repaired, 1);
}

TEST(RepairDuplicate, EveryFaceOnceInEachDirection) {
  const TriangleMesh ball = test_shapes::sphere();
  const RepairedMesh repaired = repair(merged({ball, inward(ball)}));
  EXPECT_EQ(ball.triangles.size(), repaired.counts.duplicate);
  expectClosed(repaired, signedVolume(ball));
}

// --- Orientation ---

TEST(RepairOrient, KeepsAnOutwardMesh) {
  const TriangleMesh flange = test_shapes::flange();
  const RepairedMesh repaired = repair(flange);
  EXPECT_EQ(0u, repaired.counts.flipped);
  EXPECT_EQ(flange.triangles, repaired.mesh.triangles);
}

TEST(RepairOrient, FlipsAnInwardMesh) {
  const TriangleMesh torus = test_shapes::torus();
  const RepairedMesh repaired = repair(inward(torus));
  EXPECT_EQ(torus.triangles.size(), repaired.counts.flipped);
  expectClosed(repaired, signedVolume(torus));
}

TEST(RepairOrient, ScrambledTrianglesBecomeConsistent) {
  const TriangleMesh torus = test_shapes::torus();
  for (const double share : {0.01, 0.3, 0.5, 0.9}) {
    const RepairedMesh repaired = repair(scrambled(torus, share, 1));
    expectConsistent(repaired);
    expectClosed(repaired, signedVolume(torus));
  }
}

TEST(RepairOrient, TheWallOfACavityFacesOutwardToo) {
  const RepairedMesh repaired = repair(merged({box(4, 4, 4), inward(moved(box(1, 1, 1), {1, 1, 1}))}));
  EXPECT_EQ(12u, repaired.counts.flipped);
  expectClosed(repaired, 64 + 1, 2);
}

TEST(RepairOrient, OpenBoxFollowsTheVolumeItWouldEnclose) {
  TriangleMesh open = box(1, 1, 1, 8);
  open.triangles.pop_back();
  const RepairedMesh repaired = repair(inward(open));
  EXPECT_EQ(open.triangles.size(), repaired.counts.flipped);
  EXPECT_EQ(3u, repaired.counts.open_edges);
  EXPECT_EQ(std::vector<Interior>{Interior::kWinding}, repaired.interior);
}

TEST(RepairOrient, FlatSheetKeepsTheSideOfItsLargerPart) {
  const TriangleMesh sheet = test_shapes::sheet(1, 1, 6);
  const RepairedMesh repaired = repair(scrambled(sheet, 0.3, 1));
  EXPECT_EQ(sheet.triangles, repaired.mesh.triangles);
  EXPECT_EQ(std::vector<Interior>{Interior::kSurface}, repaired.interior);
}

TEST(RepairOrient, SolidsThatShareAnEdgeEachFaceOutward) {
  const RepairedMesh repaired = repair(merged({box(1, 1, 1), inward(moved(box(1, 1, 1), {1, 1, 0}))}));
  EXPECT_EQ(1u, repaired.counts.nonmanifold_edges);
  EXPECT_EQ(12u, repaired.counts.flipped);
  expectClosed(repaired, 2);
}

TEST(RepairOrient, ADentBetweenNonManifoldEdgesStaysADent) {
  // A box with a pit of four slopes in one of its faces. Fins on the pit's rim make the pit a patch of its own, which by itself encloses a
  // negative volume.
  test_shapes::MeshBuilder builder;
  const TriangleMesh cube = box(2, 2, 2);
  for (int t = 0; t < 12; ++t)
    if (std::min({cube.corner(t, 0).z(), cube.corner(t, 1).z(), cube.corner(t, 2).z()}) < 1)
      builder.triangle(cube.corner(t, 0), cube.corner(t, 1), cube.corner(t, 2));
  const Eigen::Vector3d rim[] = {{0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}, bottom(1, 1, 1), top(1, 1, 5);
  for (int k = 0; k < 4; ++k) builder.triangle(rim[k], rim[(k + 1) % 4], bottom);
  const double volume = signedVolume(builder.mesh());
  EXPECT_NEAR(8 - 4.0 / 3, volume, 1e-12);
  for (int k = 0; k < 4; ++k) builder.triangle(rim[k], rim[(k + 1) % 4], rim[k] + Eigen::Vector3d(0, 0, 1) + 0.1 * (top - rim[k]));
  for (const bool turned : {false, true}) {
    const RepairedMesh repaired = repair(turned ? inward(builder.mesh()) : builder.mesh());
    EXPECT_EQ(4u, repaired.counts.nonmanifold_edges);
    TriangleMesh body = repaired.mesh;
    body.triangles.resize(14);
    EXPECT_NEAR(volume, signedVolume(body), 1e-12);
  }
}

TEST(RepairOrient, AMoebiusStripStaysASurface) {
  test_shapes::MeshBuilder builder;
  const auto at = [](int i, int side) -> Eigen::Vector3d {
    const double angle = 2 * test_shapes::kPi * i / 24, twist = angle / 2, r = 1 + side * 0.2 * std::cos(twist);
    return {r * std::cos(angle), r * std::sin(angle), side * 0.2 * std::sin(twist)};
  };
  for (int i = 0; i < 24; ++i) builder.quad(at(i, -1), at(i + 1, -1), at(i + 1, 1), at(i, 1));
  const RepairedMesh repaired = repair(builder.mesh());
  EXPECT_EQ(48u, repaired.mesh.triangles.size());
  EXPECT_EQ(48u, repaired.counts.open_edges);
  EXPECT_EQ(std::vector<Interior>{Interior::kSurface}, repaired.interior);
}

// --- Components and interiors ---

TEST(RepairComponents, AreNumberedByFirstTriangle) {
  TriangleMesh mesh = merged({box(1, 1, 1), moved(box(1, 1, 1), {3, 0, 0}), moved(test_shapes::sheet(1, 1, 1), {0, 5, 0})});
  std::swap(mesh.triangles[0], mesh.triangles[25]);
  const RepairedMesh repaired = repair(mesh);
  EXPECT_EQ(3u, repaired.counts.components);
  EXPECT_EQ(0, repaired.component[0]);
  EXPECT_EQ(1, repaired.component[1]);
  EXPECT_EQ(2, repaired.component[12]);
  EXPECT_EQ((std::vector<Interior>{Interior::kSurface, Interior::kClosed, Interior::kClosed}), repaired.interior);
  EXPECT_EQ(Interior::kWinding, interiorOf(repaired)) << "the components are neither all closed nor all sheets";
}

TEST(RepairComponents, TouchingAtACornerIsNotConnected) {
  EXPECT_EQ(2u, repair(merged({box(1, 1, 1), moved(box(1, 1, 1), {1, 1, 1})})).counts.components);
}

TEST(RepairInterior, BoxWithoutALidIsASurface) {
  TriangleMesh open = box(1, 1, 1);
  open.triangles.erase(std::remove_if(open.triangles.begin(), open.triangles.end(),
                                      [&](const Triangle& t) {
                                        return std::all_of(t.begin(), t.end(),
                                                           [&](int v) { return open.vertices[static_cast<std::size_t>(v)].z() > 0.5; });
                                      }),
                       open.triangles.end());
  ASSERT_EQ(10u, open.triangles.size());
  EXPECT_EQ(std::vector<Interior>{Interior::kSurface}, repair(open).interior) << "its lid is a fifth of its area";
}

/// Half of a box of side 2, without the face where it is cut: what lies at z < 1.
TriangleMesh halfBox() {
  TriangleMesh half = box(2, 2, 1, 4);
  half.triangles.erase(std::remove_if(half.triangles.begin(), half.triangles.end(),
                                      [&](const Triangle& t) {
                                        return std::all_of(t.begin(), t.end(),
                                                           [&](int v) { return half.vertices[static_cast<std::size_t>(v)].z() > 0.999; });
                                      }),
                       half.triangles.end());
  return half;
}

/// halfBox() and its mirror image, with a slit of `gap` between them.
TriangleMesh halvesApart(double gap) {
  TriangleMesh other = inward(halfBox());
  for (Eigen::Vector3d& v : other.vertices) v.z() = 2 + gap - v.z();
  return merged({halfBox(), other});
}

TEST(RepairInterior, HalvesOfAShellThatASlitPartsEncloseASolid) {
  EXPECT_EQ(std::vector<Interior>{Interior::kSurface}, repair(halfBox()).interior) << "its opening is a quarter of its area";
  EXPECT_EQ(std::vector<Interior>(2, Interior::kWinding), repair(halvesApart(0.01)).interior);
  EXPECT_EQ(std::vector<Interior>(2, Interior::kWinding), repair(inward(halvesApart(0.01))).interior);
  EXPECT_EQ(std::vector<Interior>(2, Interior::kSurface), repair(halvesApart(0.5)).interior) << "the slit is an eighth of the area";
}

TEST(RepairInterior, AHalfWithoutItsOtherIsASurfaceWhateverElseIsThere) {
  EXPECT_EQ((std::vector<Interior>{Interior::kSurface, Interior::kClosed}),
            repair(merged({halfBox(), moved(box(2, 2, 1, 4), {0, 0, 1.01})})).interior);
  EXPECT_EQ((std::vector<Interior>{Interior::kWinding, Interior::kWinding, Interior::kSurface}),
            repair(merged({halvesApart(0.01), moved(halfBox(), {5, 0, 0})})).interior);
}

TEST(RepairInterior, TheRimsOfAnOpenCupsInnerAndOuterSurfaceAreNoSlit) {
  TriangleMesh inner = inward(halfBox());
  for (Eigen::Vector3d& v : inner.vertices) v = Eigen::Vector3d(0.01, 0.01, 0.01) + v.cwiseProduct(Eigen::Vector3d(0.99, 0.99, 0.99));
  EXPECT_EQ(std::vector<Interior>(2, Interior::kSurface), repair(merged({halfBox(), inner})).interior);
}

/// A box of side 1 with a sheet of `height`, made of two triangles, standing on each edge of its top.
TriangleMesh boxWithFins(double height) {
  TriangleMesh mesh = box(1, 1, 1);
  for (int side = 0; side < 4; ++side) {
    const auto corner = [&](int k, double z) { return Eigen::Vector3d((k + 1) % 4 / 2, k % 4 / 2, z); };
    const TriangleMesh fin = {{corner(side, 1), corner(side + 1, 1), corner(side + 1, 1 + height), corner(side, 1 + height)},
                              {{0, 1, 2}, {0, 2, 3}}};
    mesh = merged({mesh, fin});
  }
  return mesh;
}

TEST(RepairInterior, FinsEncloseNothingAndOpenNothing) {
  for (const double height : {0.01, 0.5, 5.0}) {  // even if closing them would take more than a tenth of the whole area
    const TriangleMesh mesh = boxWithFins(height);
    const RepairedMesh repaired = repair(mesh);
    ASSERT_EQ(repaired.counts.components, 1U);
    EXPECT_EQ(repaired.counts.nonmanifold_edges, 4U);
    EXPECT_EQ(repaired.interior[0], Interior::kClosed);
    for (std::size_t t = 0; t < repaired.sheet.size(); ++t) EXPECT_EQ(repaired.sheet[t], t >= 12) << t;
  }
}

TEST(RepairInterior, ATubeThatTouchesItselfIsNoFin) {
  // Of a tube of six sides, open at both ends, two opposite edges meet halfway.
  test_shapes::MeshBuilder builder;
  const std::vector<Eigen::Vector2d> hexagon{{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}};
  const auto corner = [&](std::size_t i, int row) -> Eigen::Vector3d {
    const bool is_pinched = i % 3 == 0 && (row == 1 || row == 2);
    return is_pinched ? Eigen::Vector3d(0, 0, row) : Eigen::Vector3d(hexagon[i % 6].x(), hexagon[i % 6].y(), row);
  };
  for (std::size_t i = 0; i < 6; ++i)
    for (int row = 0; row < 3; ++row) builder.quad(corner(i, row), corner(i + 1, row), corner(i + 1, row + 1), corner(i, row + 1));
  const RepairedMesh repaired = repair(builder.mesh());
  EXPECT_EQ(repaired.counts.nonmanifold_edges, 1u);
  EXPECT_EQ(interiorOf(repaired), Interior::kSurface);
}

TEST(RepairInterior, AnOpenBoxAttachedToAClosedOneIsAFin) {
  TriangleMesh open = moved(box(1, 1, 1), {1, 0, 1});  // shares one edge with the box below
  open.triangles.resize(10);
  const RepairedMesh repaired = repair(merged({box(1, 1, 1), open}));
  ASSERT_EQ(repaired.counts.components, 1U);
  ASSERT_EQ(repaired.counts.nonmanifold_edges, 1U);
  EXPECT_EQ(repaired.interior[0], Interior::kClosed);
  for (std::size_t t = 0; t < repaired.sheet.size(); ++t) EXPECT_EQ(repaired.sheet[t], t >= 12) << t;
}

TEST(RepairInterior, WallsThatEncloseAreNotFins) {
  const RepairedMesh two = repair(merged({box(1, 1, 1), moved(box(1, 1, 1), {1, 0, 1})}));
  EXPECT_EQ(two.counts.nonmanifold_edges, 1U);
  EXPECT_EQ(std::count(two.sheet.begin(), two.sheet.end(), 1), 0);
  TriangleMesh torn = box(1, 1, 1, 8);  // almost closed, and attached to a closed one
  torn.triangles.pop_back();
  const RepairedMesh hung = repair(merged({box(1, 1, 1, 8), moved(torn, {1, 0, 1})}));
  EXPECT_EQ(hung.interior[0], Interior::kWinding);
  EXPECT_EQ(std::count(hung.sheet.begin(), hung.sheet.end(), 1), 0);
  const RepairedMesh alone = repair(test_shapes::sheet());
  EXPECT_EQ(std::count(alone.sheet.begin(), alone.sheet.end(), 1), 2);
}

TEST(RepairInterior, Names) {
  EXPECT_STREQ("closed", name(Interior::kClosed));
  EXPECT_STREQ("winding", name(Interior::kWinding));
  EXPECT_STREQ("surface", name(Interior::kSurface));
}

}  // namespace
}  // namespace collision_hulls
