// How far a mesh and its inside protrude, against closed forms.
#include "verify/mesh_protrusion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "box_with_slit.h"
#include "octahedron.h"
#include "solids.h"
#include "verify/round_shapes.h"
#include "verify_shapes.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

/// A block around that box with a trench in its top above the slit, whose sides meet at right angles at `depth` below z = 0.
TriangleMesh blockWithTrench(double depth) {
  constexpr double kTop = 5e-4, kFrom = 0.3, kTo = 0.7;
  const double half = kTop + depth;
  const auto outer = [](int k, double z) { return Eigen::Vector3d(k == 1 || k == 2 ? 2.5 : -1.5, k >= 2 ? 1.5 : -1.5, z); };
  const auto inner = [&](int k) { return Eigen::Vector3d(k == 1 || k == 2 ? kTo : kFrom, k >= 2 ? half : -half, kTop); };
  const Eigen::Vector3d start(kFrom, 0, -depth), end(kTo, 0, -depth);
  test_shapes::MeshBuilder builder;
  builder.quad(outer(0, -1.5), outer(3, -1.5), outer(2, -1.5), outer(1, -1.5));
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    builder.quad(outer(k, -1.5), outer(next, -1.5), outer(next, kTop), outer(k, kTop));
    builder.quad(outer(k, kTop), outer(next, kTop), inner(next), inner(k));
  }
  builder.quad(inner(0), inner(1), end, start);
  builder.quad(inner(2), inner(3), start, end);
  builder.triangle(inner(1), inner(2), end);
  builder.triangle(inner(3), inner(0), start);
  return builder.mesh();
}

TEST(MeshProtrusion, TheBoundAllowsForTheRoundingOfCoordinates) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const FarAway far(seed);
    const Solid body = solidOf(far.speck), solid = solidOf(far.bracket);
    EXPECT_GE(static_cast<Exact>(meshProtrusion(far.speck, body, solid, 1e-9).bound), far.distance()) << seed;
  }
}

/// Beside openings, on which side of the border a point lies is uncertain by the blur, of the body as of the solid.
TEST(MeshProtrusion, TheBoundAllowsForTheBlurOfBoth) {
  const TriangleMesh open = test_shapes::boxWithWindow(0.1), speck = moved(box(0.1, 0.1, 0.1), {0.45, 0.45, 0.45});
  const auto bound = [](const TriangleMesh& body, const TriangleMesh& solid) {
    return meshProtrusion(body, solidOf(body), solidOf(solid), 1e-9).bound;
  };
  const double blur = solidOf(open).sideError();
  ASSERT_GT(blur, 0);
  EXPECT_LT(bound(speck, box(1, 1, 1)), 0.01 * blur);
  EXPECT_GE(bound(speck, open), blur);
  EXPECT_GE(bound(open, moved(box(3, 3, 3), {-1, -1, -1})), blur);
}

/// The summit is anywhere in the body, and nothing on the body's surface is as far away.
// A loose segment is searched as a triangle without area. From one block to another, it is furthest from both in the middle of the gap.
TEST(MeshProtrusion, SegmentsThatLeaveTheSolidCount) {
  constexpr double kFrom = 0.15, kTo = 0.4, kHigh = 0.3, kFurthest = (kTo - kFrom) / 2;
  test_shapes::RandomPoints random(2);
  for (int i = 0; i < 400; ++i) {
    const Eigen::Isometry3d turn(random.rotation());
    const TriangleMesh blocks = merged({box(kFrom, kHigh, kHigh), moved(box(1, kHigh, kHigh), {kTo, 0, 0})});
    const auto in = [&](double low, double high) {
      return Eigen::Vector3d(random.number(low, high), random.number(0.01, kHigh - 0.01), random.number(0.01, kHigh - 0.01));
    };
    const TriangleMesh segment{{turn * in(0.01, kFrom - 0.01), turn * in(kTo + 0.01, 1)}, {{0, 1, 1}}};
    const Protrusion far = largestOnMesh(segment, solidOf(transformed(blocks, turn)), 1e-4);
    EXPECT_GE(far.bound, kFurthest * (1 - 1e-9)) << i;
    EXPECT_LE(far.found, kFurthest * (1 + 1e-9)) << i;
    EXPECT_GE(far.bound, far.found) << i;
  }
}

TEST(MeshProtrusion, NoSummitIsBeyondTheBound) {
  test_shapes::RandomPoints random(10);
  const Solid solid = solidOf(test_shapes::octahedronOfSheets(0.3));
  for (int i = 0; i < 40; ++i) {
    const Eigen::Isometry3d pose = Eigen::Translation3d(random.inCube(0.03)) * Eigen::Isometry3d(random.rotation());
    const TriangleMesh body = transformed(moved(box(0.15, 0.15, 0.15), {-0.075, -0.075, -0.075}), pose);
    const Protrusion far = meshProtrusion(body, solidOf(body), solid, 1e-3);
    EXPECT_GE(far.bound, 0.3) << i;
    EXPECT_LE(far.bound, 0.305) << i;
  }
}

/// The search inside is of the body as it was welded.
TEST(MeshProtrusion, CountsHowFarTheBodysVerticesWereMoved) {
  const TriangleMesh body = withLooseTop(lBracket(), kHigher);
  const Protrusion far = meshProtrusion(body, solidOf(body), solidOf(moved(box(2, 2, 3), {-0.5, -0.5, -0.5})), 1e-9);
  EXPECT_NEAR(far.bound, kHigher, 1e-8);
}

/// In the middle of the slit, the box's lid is furthest from the trench's sides, further than anything of the box's surface.
TEST(MeshProtrusion, TheLidsOfCracksBelongToTheBody) {
  constexpr double kDepth = 1e-4, kHalfWidth = 1e-5;
  const TriangleMesh body = boxWithSlit(kHalfWidth);
  const Solid of_body = solidOf(body), solid = solidOf(blockWithTrench(kDepth));
  ASSERT_TRUE(!of_body.hasOpenings() && !solid.hasOpenings());
  const Eigen::Vector3d middle(0.5, 0, -1e-7);
  ASSERT_TRUE(of_body.contains(middle) && !solid.contains(middle));
  const double distance = kDepth / std::sqrt(2.0);
  EXPECT_NEAR(solid.distance(middle), distance, 1e-7);
  EXPECT_LT(largestOnMesh(body, solid, 1e-9).bound, 0.95 * distance) << "so that the test can tell";
  EXPECT_GE(meshProtrusion(body, of_body, solid, 1e-9).bound, distance);
}

/// The surface of the bracket in triangles that do not touch, so that it encloses nothing: then the body's inside is further from it than
/// anything on the body's surface. Its largest inscribed ball touches both outer sides and the inner edge.
TEST(MeshProtrusion, TheInsideOfABodyCounts) {
  const double t = 0.2;
  const TriangleMesh body = lBracket(1, t, 1, 8);
  TriangleMesh apart;
  for (int i = 0; i < static_cast<int>(body.triangles.size()); ++i) {
    const Eigen::Vector3d centre = (body.corner(i, 0) + body.corner(i, 1) + body.corner(i, 2)) / 3;
    for (int k = 0; k < 3; ++k) apart.vertices.push_back(centre + 0.98 * (body.corner(i, k) - centre));
    apart.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const double radius = t * std::sqrt(2.0) / (1 + std::sqrt(2.0));
  const Solid sheets = solidOf(apart), solid = solidOf(body);
  const Protrusion far = meshProtrusion(body, solid, sheets, 1e-3);
  EXPECT_GE(far.bound, radius);
  EXPECT_LE(far.bound, radius + 5e-3);
  EXPECT_NEAR(far.found, radius, 5e-3);
  EXPECT_LT(largestOnMesh(body, sheets, 1e-3).bound, 0.01);
  EXPECT_LT(meshProtrusion(body, solid, solid, 1e-3).bound, 1e-2);
}

/// A box with a window, and the same box filled up but for a pit below the window. The middle of the window is further from that than
/// anything else of the body, but no summit: further up it would be further still, only that is no longer in the body.
TEST(MeshProtrusion, AllOfTheInsideCountsWhereItEndsInMidAir) {
  const TriangleMesh body = test_shapes::boxWithWindow(0.2);
  const TriangleMesh pitted = moved(test_shapes::squareVessel({{0.5, 0}, {0.5, 1}, {0.2, 1}, {0.001, 0.801}}), {0.5, 0.5, 0});
  const Protrusion far = meshProtrusion(body, solidOf(body), solidOf(pitted), 0.03);
  EXPECT_GE(far.bound, 0.2 / std::sqrt(2.0));
  EXPECT_LE(far.bound, 0.2 / std::sqrt(2.0) + 0.03);
}

}  // namespace
}  // namespace collision_hulls
