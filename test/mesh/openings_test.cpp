#include "collision_hulls/mesh/openings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_hulls/error.h"
#include "collision_hulls/measure/solid.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::pipe;

/// A unit cube without its top.
TriangleMesh bin() {
  TriangleMesh mesh;
  const TriangleMesh cube = test_shapes::box(1, 1, 1);
  mesh.vertices = cube.vertices;
  for (int t = 0; t < static_cast<int>(cube.triangles.size()); ++t) {
    const double top = boundingBox(cube).max().z();
    if (cube.corner(t, 0).z() < top || cube.corner(t, 1).z() < top || cube.corner(t, 2).z() < top)
      mesh.triangles.push_back(cube.triangles[static_cast<std::size_t>(t)]);
  }
  return mesh;
}

TriangleMesh unwelded(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const int first = static_cast<int>(soup.vertices.size());
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(mesh.corner(t, k));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

double volumeOf(const TriangleMesh& mesh) {
  const RepairedMesh repaired = repair(mesh);
  EXPECT_EQ(Interior::kClosed, interiorOf(repaired));
  return Solid(repaired).volume();
}

TEST(OpeningsOf, AClosedMeshHasNone) {
  EXPECT_TRUE(openingsOf(repair(test_shapes::box(1, 1, 1))).empty());
  EXPECT_TRUE(openingsOf(repair({})).empty());
  EXPECT_TRUE(openingsOf(repair(test_shapes::openBox())).empty());  // its wall has two surfaces
}

TEST(OpeningsOf, ARoundOneHasItsDiameterAndCentre) {
  const std::vector<Opening> openings = openingsOf(repair(pipe(0.3, 2, 64)));
  ASSERT_EQ(2u, openings.size());
  for (const Opening& opening : openings) {
    EXPECT_EQ(64u, opening.rim.size());
    EXPECT_NEAR(0.6, opening.width, 1e-12);
    EXPECT_NEAR(1, std::abs(opening.center.z() - 1), 1e-12);
    EXPECT_NEAR(0, opening.center.head<2>().norm(), 1e-12);
  }
}

TEST(OpeningsOf, ARectangularOneHasItsDiagonalWhereverItsCornersAre) {
  const std::vector<Opening> openings = openingsOf(repair(bin()));
  ASSERT_EQ(1u, openings.size());
  EXPECT_NEAR(std::sqrt(2), openings[0].width, 1e-12);
  TriangleMesh finer = bin();  // halve one edge of the rim, four times: the mean of its corners moves, that of the rim does not
  for (int round = 0; round < 4; ++round) {
    const Opening before = openingsOf(repair(finer)).front();
    const Eigen::Vector3d middle = (before.rim[0] + before.rim[1]) / 2;
    const int added = static_cast<int>(finer.vertices.size());
    finer.vertices.push_back(middle);
    for (std::size_t t = 0; t < finer.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle old = finer.triangles[t];
        const auto is = [&](std::size_t corner, std::size_t i) {
          return finer.vertices[static_cast<std::size_t>(old[corner])] == before.rim[i];
        };
        if (!is(k, 0) || !is((k + 1) % 3, 1)) continue;
        finer.triangles[t][(k + 1) % 3] = added;
        finer.triangles.push_back({added, old[(k + 1) % 3], old[(k + 2) % 3]});
        t = finer.triangles.size() - 1;
        break;
      }
  }
  const std::vector<Opening> again = openingsOf(repair(finer));
  ASSERT_EQ(1u, again.size());
  EXPECT_EQ(8u, again[0].rim.size());
  EXPECT_NEAR(std::sqrt(2), again[0].width, 1e-12);
}

TEST(OpeningsOf, SheetsAndFinsHaveNone) {
  EXPECT_TRUE(openingsOf(repair(test_shapes::sheet(1, 2, 3))).empty());
  EXPECT_TRUE(openingsOf(repair(test_shapes::singleTriangle())).empty());
  TriangleMesh finned = test_shapes::box(1, 1, 1);  // a fin along an edge of the cube
  const Eigen::Vector3d a = finned.corner(0, 0), b = finned.corner(0, 1);
  const int out = static_cast<int>(finned.vertices.size());
  finned.vertices.push_back((a + b) / 2 + 2 * ((a + b) / 2 - boundingBox(finned).center()));
  finned.triangles.push_back({finned.triangles[0][0], finned.triangles[0][1], out});
  ASSERT_EQ(2u, repair(finned).counts.open_edges);
  EXPECT_TRUE(openingsOf(repair(finned)).empty());
}

TEST(CloseOpenings, APipeBecomesASolidRod) {
  const TriangleMesh closed = closeOpenings(pipe(0.3, 2, 64), 0.61);
  EXPECT_NEAR(64 * 0.5 * 0.09 * std::sin(2 * test_shapes::kPi / 64) * 2, volumeOf(closed), 1e-12);
}

TEST(CloseOpenings, OnlyThoseUpToTheWidth) {
  const TriangleMesh shell = test_shapes::merged({pipe(0.3, 2, 16), test_shapes::moved(pipe(0.1, 2, 16), {3, 0, 0})});
  EXPECT_EQ(4u, openingsOf(repair(shell)).size());
  EXPECT_EQ(2u, openingsOf(repair(closeOpenings(shell, 0.2001))).size());
  EXPECT_EQ(4u, openingsOf(repair(closeOpenings(shell, 0.1999))).size());
  EXPECT_EQ(0u, openingsOf(repair(closeOpenings(shell, 0.6001))).size());
  EXPECT_EQ(shell.triangles, closeOpenings(shell, 0).triangles);
}

TEST(CloseOpenings, KeepsWhatWasThere) {
  const TriangleMesh soup = unwelded(bin());
  const TriangleMesh closed = closeOpenings(soup, 2);
  ASSERT_EQ(soup.triangles.size() + 4, closed.triangles.size());
  EXPECT_TRUE(std::equal(soup.triangles.begin(), soup.triangles.end(), closed.triangles.begin()));
  EXPECT_TRUE(std::equal(soup.vertices.begin(), soup.vertices.end(), closed.vertices.begin()));
  EXPECT_NEAR(1, volumeOf(closed), 1e-12);
}

TEST(CloseOpenings, LidsFaceOutwardWhicheverWayTheShellFaced) {
  TriangleMesh turned = bin();
  for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(1, volumeOf(closeOpenings(turned, 2)), 1e-12);
}

TEST(CloseOpenings, RefusesWidthsThatAreNone) {
  for (const double width : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    try {
      closeOpenings(bin(), width);
      FAIL() << width;
    } catch (const Error& error) {
      EXPECT_EQ(ErrorCode::kBadOption, error.code());
    }
  }
}

}  // namespace
}  // namespace collision_hulls
