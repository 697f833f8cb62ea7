#include "mesh/sheets/inner_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/repair.h"
#include "shapes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using test_shapes::box;
using test_shapes::merged;
using test_shapes::MeshBuilder;
using test_shapes::moved;

using Point = Eigen::Vector3d;

/// A rectangle of n x n squares with the corner p and the sides u and v.
TriangleMesh rectangle(const Point& p, const Point& u, const Point& v, int n = 1) {
  MeshBuilder builder;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Point corner = p + i * u / n + j * v / n;
      builder.quad(corner, corner + u / n, corner + (u + v) / n, corner + v / n);
    }
  return builder.mesh();
}

/// The box of this size as six faces of 2 x 2 squares, without the last `missing` ones: of x = 0, 1; y = 0, 1; z = 0, 1.
TriangleMesh faces(const Point& size, std::size_t missing = 0) {
  const Point x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z()), o = Point::Zero();
  std::vector<TriangleMesh> parts{rectangle(o, z, y, 2), rectangle(x, y, z, 2), rectangle(o, x, z, 2),
                                  rectangle(y, z, x, 2), rectangle(o, y, x, 2), rectangle(z, x, y, 2)};
  parts.resize(parts.size() - missing);
  return merged(parts);
}

/// A box of 2 x 2 x 2 with walls across its middle: 1: x = 1; 2: y = 1; 4: z = 1.
TriangleMesh dividedBox(int walls, std::size_t missing = 0) {
  const Point x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
  TriangleMesh mesh = faces({2, 2, 2}, missing);
  if (walls & 1) append(mesh, rectangle(x / 2, y, z, 2));
  if (walls & 2) append(mesh, rectangle(y / 2, x, z, 2));
  if (walls & 4) append(mesh, rectangle(z / 2, x, y, 2));
  return mesh;
}

/// Each triangle turned or not, at random.
TriangleMesh shuffled(TriangleMesh mesh, unsigned seed) {
  std::mt19937 random(seed);
  for (Triangle& t : mesh.triangles)
    if (random() % 2) std::swap(t[1], t[2]);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  return mesh;
}

/// [m^2] of the triangles that are in sheets.
double sheetArea(const RepairedMesh& mesh) {
  TriangleMesh sheets{mesh.mesh.vertices, {}};
  for (std::size_t t = 0; t < mesh.sheet.size(); ++t)
    if (mesh.sheet[t]) sheets.triangles.push_back(mesh.mesh.triangles[t]);
  return area(sheets);
}

/// However its triangles are turned and ordered, the mesh is closed without the walls, and encloses the volume.
void expectSolid(const TriangleMesh& mesh, double volume, double walls, unsigned orders = 5) {
  for (unsigned seed = 0; seed < orders; ++seed) {
    const RepairedMesh repaired = repair(seed == 0 ? mesh : shuffled(mesh, seed));
    EXPECT_EQ(repaired.counts.open_edges, 0U) << "seed " << seed;
    EXPECT_EQ(interiorOf(repaired), Interior::kClosed) << "seed " << seed;
    EXPECT_NEAR(sheetArea(repaired), walls, 1e-12) << "seed " << seed;
    const Solid solid(repaired);
    EXPECT_NEAR(solid.volume(), volume, 1e-12) << "seed " << seed;
    EXPECT_FALSE(solid.hasOpenings()) << "seed " << seed;
  }
}

TEST(InnerWalls, AcrossABox) {
  for (const int wall : {1, 2, 4}) expectSolid(dividedBox(wall), 8, 4);
}

TEST(InnerWalls, TwoOrThreeThatCross) {
  for (const int walls : {3, 5, 6}) expectSolid(dividedBox(walls), 8, 8);
  expectSolid(dividedBox(7), 8, 12);
}

TEST(InnerWalls, SeveralInARow) {
  TriangleMesh mesh = box(1, 1, 1);
  for (int i = 1; i < 5; ++i) {
    TriangleMesh next = moved(box(1, 1, 1), {1.0 * i, 0, 0});
    next.triangles.erase(std::remove_if(next.triangles.begin(), next.triangles.end(),
                                        [&](const Triangle& t) {
                                          return std::all_of(t.begin(), t.end(), [&](int v) {
                                            return std::abs(next.vertices[static_cast<std::size_t>(v)].x() - i) < 0.5;
                                          });
                                        }),
                         next.triangles.end());
    append(mesh, next);
  }
  expectSolid(mesh, 5, 4);
}

TEST(InnerWalls, AtTheCornerOfAnL) {
  TriangleMesh mesh = test_shapes::lBracket(1, 0.25, 1);
  append(mesh, rectangle({0.25, 0, 0}, {0, 0.25, 0}, {0, 0, 1}));
  // Of the wall's edges only that at the corner is one of the skin's: the others are open, and the wall is a fin.
  EXPECT_EQ(repair(mesh).counts.open_edges, 3U);
  EXPECT_NEAR(test_shapes::solidOf(mesh).volume(), 2 * 0.25 - 0.0625, 1e-12);
  const std::vector<Eigen::Vector2d> outline{{0, 0}, {0.25, 0}, {1, 0}, {1, 0.25}, {0.25, 0.25}, {0.25, 1}, {0, 1}};
  TriangleMesh divided = test_shapes::prism(outline, {{1, 2, 3}, {1, 3, 4}, {0, 1, 4}, {0, 4, 5}, {0, 5, 6}}, 1);
  append(divided, rectangle({0.25, 0, 0}, {0, 0.25, 0}, {0, 0, 1}));
  expectSolid(divided, 2 * 0.25 - 0.0625, 0.25);
}

TEST(InnerWalls, OfTwoBoxesWithOneFaceInCommon) {
  for (const double height : {1.0, 3.0}) {
    TriangleMesh second = faces({1, 1, height}, 1);  // without its top, which is ...
    for (Point& p : second.vertices) p.z() = -p.z();
    append(second, rectangle({0, 0, -height}, {1, 0, 0}, {0, 1, 0}, 2));
    TriangleMesh both = faces({1, 1, 1});  // ... the bottom of the first one
    for (Triangle t : second.triangles) {
      for (int& v : t) v += static_cast<int>(both.vertices.size());
      if (second.corner(0, 0).z() > 0) std::swap(t[0], t[1]);
      both.triangles.push_back(t);
    }
    both.vertices.insert(both.vertices.end(), second.vertices.begin(), second.vertices.end());
    const RepairedMesh repaired = repair(both);
    EXPECT_EQ(repaired.counts.open_edges, 0U);
    EXPECT_NEAR(Solid(repaired).volume(), 1 + height, 1e-12);
  }
}

TEST(InnerWalls, LargerThanWhatTheyDivide) {
  // The wall is a steep pyramid, with ten times the area of the skin on either side of its rim.
  TriangleMesh mesh = faces({1, 1, 40});
  const TriangleMesh rim = rectangle({0, 0, 20}, {1, 0, 0}, {0, 1, 0}, 2);
  const Point top(0.5, 0.5, 39);
  MeshBuilder builder;
  for (const Point& p : {Point(0, 0, 20), Point(1, 0, 20), Point(1, 1, 20), Point(0, 1, 20)}) {
    const Point c(0.5, 0.5, 20), next = c + Point(-(p - c).y(), (p - c).x(), 0);
    builder.triangle(p, (p + next) / 2, top);
    builder.triangle((p + next) / 2, next, top);
  }
  append(mesh, builder.mesh());
  expectSolid(mesh, 40, area(builder.mesh()));
}

TEST(InnerWalls, ThatCrossTheSkin) {
  // The top of the box bulges at one end and is dented at the other: a flat wall across its rim begins inside and ends outside.
  const double height = 0.25;
  TriangleMesh mesh = faces({2, 2, 2}, 1);
  const Point bulge(2.0 / 3, 1, 2 + height), dent(4.0 / 3, 1, 2 - height);
  const std::vector<Point> rim{{0, 0, 2}, {1, 0, 2}, {2, 0, 2}, {2, 1, 2}, {2, 2, 2}, {1, 2, 2}, {0, 2, 2}, {0, 1, 2}};
  MeshBuilder top;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t next = (i + 1) % rim.size();
    top.triangle(rim[i], rim[next], i >= 1 && i < 5 ? dent : bulge);
  }
  top.triangle(rim[1], dent, bulge);
  top.triangle(rim[5], bulge, dent);
  append(mesh, top.mesh());
  append(mesh, rectangle({0, 0, 2}, {2, 0, 0}, {0, 2, 0}, 2));
  expectSolid(mesh, 8, 4);
}

/// A divided box and another one that is turned about an edge of it, into it.
TriangleMesh boxesThatCrossAtAnEdge() {
  TriangleMesh turned = faces({2, 2, 2});
  for (Point& p : turned.vertices) p = Eigen::AngleAxisd(0.5, Point::UnitZ()) * p;
  return merged({dividedBox(1), turned});
}

TEST(InnerWalls, BesideABodyThatCrossesItAtAnEdge) {
  expectSolid(boxesThatCrossAtAnEdge(), 16, 4, 1);  // which winding numbers lie around the edge, only the triangles' turns tell
}

TEST(InnerWalls, BesideAFinWhereBodiesCross) {
  TriangleMesh mesh = boxesThatCrossAtAnEdge();
  append(mesh, rectangle({0, 0, 0}, {0, 0, 2}, {-1, -1, 0}, 2));
  const RepairedMesh repaired = repair(mesh);
  EXPECT_EQ(interiorOf(repaired), Interior::kClosed);
  EXPECT_NEAR(Solid(repaired).volume(), 16, 1e-12);
  EXPECT_NEAR(sheetArea(repaired), 4 + 2 * std::sqrt(2.0), 1e-12);
}

TEST(InnerWalls, NoneWhereAFaceOfTwoBodiesWasGivenOnce) {
  // One leans across the other, so no order of their sides tells the spaces apart, except that in a thin rod along an edge.
  TriangleMesh leaning = faces({2, 2, 2}), mesh = faces({2, 2, 2});
  for (Point& p : leaning.vertices) p.x() += 0.4 * p.z();
  for (const Triangle& t : leaning.triangles) {
    const bool is_bottom = std::all_of(t.begin(), t.end(), [&](int v) { return leaning.vertices[static_cast<std::size_t>(v)].z() == 0; });
    if (!is_bottom) append(mesh, TriangleMesh{leaning.vertices, {t}});
  }
  append(mesh, moved(faces({0.1, 0.1, 2}), {-0.1, -0.1, 0}));
  const RepairedMesh repaired = repair(mesh);
  EXPECT_EQ(sheetArea(repaired), 0);
  const Solid solid(repaired);
  EXPECT_TRUE(solid.contains({0.1, 1, 1.9}));
  EXPECT_TRUE(solid.contains({1, 1, 1}));
  EXPECT_TRUE(solid.contains({2.6, 1, 1.9}));
  EXPECT_FALSE(solid.contains({2.6, 1, 0.5}));
}

TEST(InnerWalls, ABodyThatStandsOnAWallInsideIsInside) {
  TriangleMesh mesh = test_shapes::subdivided(faces({4, 4, 4}), 2);
  append(mesh, rectangle({0, 0, 2}, {4, 0, 0}, {0, 4, 0}, 4));
  append(mesh, moved(faces({2, 2, 1}), {1, 1, 2}));  // its floor is a part of the wall
  expectSolid(mesh, 64, 16 + 4 + 8);
}

TEST(InnerWalls, NoneInAnOpenBox) {
  // Across a box without a top: the wall's upper edges are open as well.
  const RepairedMesh trough = repair(dividedBox(1, 1));
  EXPECT_EQ(interiorOf(trough), Interior::kSurface);
  EXPECT_EQ(Solid(trough).volume(), 0);
  // Below the missing top: the part under the wall is closed, and the rest hangs on it.
  const TriangleMesh covered = dividedBox(4, 1);
  const RepairedMesh repaired = repair(covered);
  EXPECT_NEAR(Solid(repaired).volume(), 4, 1e-12);
  EXPECT_NEAR(sheetArea(repaired), 8, 1e-12);
  // With one triangle missing, the interior is still that within the skin, and the wall stays a wall.
  TriangleMesh torn = test_shapes::subdivided(dividedBox(1), 4);
  torn.triangles.erase(torn.triangles.begin());
  const RepairedMesh open = repair(torn);
  EXPECT_EQ(interiorOf(open), Interior::kWinding);
  EXPECT_EQ(sheetArea(open), 0);
}

TEST(InnerWalls, FinsOnASolidWithAWallStayFins) {
  TriangleMesh mesh = dividedBox(1);
  append(mesh, rectangle({0, 0, 2}, {0, 2, 0}, {0, 0, 1}, 2));    // outside, along an edge of the box
  append(mesh, rectangle({1, 0, 1}, {0, 2, 0}, {0.5, 0, 0}, 2));  // inside, on the wall
  const RepairedMesh repaired = repair(mesh);
  EXPECT_EQ(interiorOf(repaired), Interior::kClosed);
  EXPECT_NEAR(Solid(repaired).volume(), 8, 1e-12);
  EXPECT_NEAR(sheetArea(repaired), 4 + 2 + 1, 1e-12);
}

TEST(InnerWalls, WhatAnOpenTubeStandsOnIsSkin) {
  TriangleMesh mesh = test_shapes::subdivided(faces({4, 4, 4}), 2);
  append(mesh, rectangle({0, 0, 2}, {4, 0, 0}, {0, 4, 0}, 4));
  const Point x(2, 0, 0), y(0, 2, 0), up(0, 0, 2);
  append(mesh, rectangle({1, 1, 4}, x, up, 2));
  append(mesh, rectangle({3, 1, 4}, y, up, 2));
  append(mesh, rectangle({3, 3, 4}, -x, up, 2));
  append(mesh, rectangle({1, 3, 4}, -y, up, 2));
  const RepairedMesh repaired = repair(mesh);
  EXPECT_EQ(interiorOf(repaired), Interior::kClosed);
  EXPECT_NEAR(Solid(repaired).volume(), 64, 1e-12);
  EXPECT_NEAR(sheetArea(repaired), 16 + 4 * 4, 1e-12);
}

TEST(InnerWalls, FlatLayersEncloseNothing) {
  const Point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  MeshBuilder builder;
  for (const double share : {0.2, 0.3, 0.4}) {
    const Point middle(share, share, 0);
    builder.triangle(a, b, middle);
    builder.triangle(b, c, middle);
    builder.triangle(c, a, middle);
  }
  const RepairedMesh repaired = repair(builder.mesh());
  EXPECT_EQ(repaired.counts.nonmanifold_edges, 3U);
  EXPECT_EQ(sheetArea(repaired), 0);
}

TEST(InnerWalls, OtherComponentsStayAsTheyAre) {
  const TriangleMesh ball = moved(test_shapes::sphere(), {9, 0, 0}), sheet = moved(test_shapes::sheet(), {0, 9, 0});
  const RepairedMesh repaired = repair(merged({sheet, dividedBox(1), ball}));
  EXPECT_NEAR(Solid(repaired).volume(), 8 + signedVolume(ball), 1e-12);
  EXPECT_NEAR(sheetArea(repaired), 4 + area(sheet), 1e-12);
}

TEST(InnerWalls, OneHullCoversADividedBox) {
  const Solid solid = test_shapes::solidOf(dividedBox(3));
  EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_TRUE(solid.contains({1.5, 1.5, 1.5}));
  EXPECT_FALSE(solid.contains({2.5, 1.5, 1.5}));
  EXPECT_LT(protrusion({test_shapes::boxHull({0, 0, 0}, {2, 2, 2})}, solid, 1e-3).bound, 2e-3);
}

}  // namespace
}  // namespace collision_hulls
