// FCL in the settings used here, on pairs whose distance is known.
#include "query/fcl_queries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "check/validate_exact.h"
#include "check/validate_probes.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using Status = FclAnswer::Status;

/// A box about the origin.
ConvexHull boxHull(const Vector3d& sides) {
  return convexHull(test_shapes::moved(test_shapes::box(sides.x(), sides.y(), sides.z()), -sides / 2).vertices);
}

Eigen::Isometry3d shift(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// A cube of side 1, and one of side 1/2 rotated to point a corner at the first one's face x = 1/2 from a distance of `gap`.
Eigen::Isometry3d cornerTo(double gap, double scale) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Vector3d corner = Vector3d(-1, -1, -1) * scale / 4;
  pose.linear() =
      (Eigen::AngleAxisd(0.3, Vector3d::UnitX()) * Eigen::Quaterniond::FromTwoVectors(corner, -Vector3d::UnitX())).toRotationMatrix();
  pose.translation() = Vector3d(scale / 2 + gap, 0.0712 * scale, -0.0391 * scale) - pose.linear() * corner;
  return pose;
}

TEST(FclMesh, EmptyWithoutTriangles) {
  EXPECT_TRUE(FclMesh(TriangleMesh{}).empty());
  EXPECT_FALSE(FclMesh(test_shapes::singleTriangle()).empty());
}

TEST(FclMesh, IsASurface) {
  const ConvexHull cube = boxHull({1, 1, 1});
  const FclMesh fcl(surface(cube)), small(surface(boxHull({0.2, 0.2, 0.2})));
  EXPECT_NEAR(fclDistance(fcl, Vector3d(0.1, 0, 0)).distance, 0.4, 1e-9);
  EXPECT_NEAR(fclDistance(fcl, small, shift(0.1, 0, 0)).distance, 0.3, 1e-9);
}

class ClosedForm : public testing::TestWithParam<double> {};  // the side of the cube [m]

TEST_P(ClosedForm, PointsAndHulls) {
  const double side = GetParam(), tolerance = kFclTolerance * side;
  const FclHull cube(boxHull(Vector3d::Constant(side)));
  EXPECT_NEAR(fclDistance(cube, Vector3d(100, 0.013, -0.007) * side).distance, 99.5 * side, tolerance);
  EXPECT_NEAR(fclDistance(cube, Vector3d(1.5, 2.5, 2.5) * side).distance, 3 * side, tolerance);
  EXPECT_NEAR(fclDistance(cube, Vector3d(0.5 + 1e-5, 0.013, -0.007) * side).distance, 1e-5 * side, tolerance);
  EXPECT_EQ(fclDistance(cube, Vector3d(0.31, 0.013, -0.007) * side).distance, 0);
}

TEST_P(ClosedForm, HullsAndHulls) {
  const double side = GetParam(), tolerance = kFclTolerance * side;
  const FclHull cube(boxHull(Vector3d::Constant(side))), other(boxHull(Vector3d::Constant(side / 2)));
  for (double gap : {100.0, 1.0, 1e-2, 1e-5, 1e-8, 0.0}) {
    const FclAnswer answer = fclDistance(cube, other, cornerTo(gap * side, side));
    ASSERT_EQ(answer.status, Status::kDistance);
    EXPECT_NEAR(answer.distance, gap * side, tolerance) << gap;
  }
  EXPECT_EQ(fclDistance(cube, other, cornerTo(-0.01 * side, side)).distance, 0);
  EXPECT_EQ(fclDistance(cube, other, cornerTo(-0.9 * side, side)).distance, 0) << "contained";
}

TEST_P(ClosedForm, MeshesAndMeshes) {
  const double side = GetParam(), tolerance = kFclTolerance * side;
  const FclMesh cube(surface(boxHull(Vector3d::Constant(side)))), other(surface(boxHull(Vector3d::Constant(side / 2))));
  for (double gap : {100.0, 1.0, 1e-2, 1e-5, 1e-8, 0.0})
    EXPECT_NEAR(fclDistance(cube, other, cornerTo(gap * side, side)).distance, gap * side, tolerance) << gap;
  EXPECT_EQ(fclDistance(cube, other, cornerTo(-0.01 * side, side)).distance, 0);
}

INSTANTIATE_TEST_SUITE_P(Sides, ClosedForm, testing::Values(1.0, 0.5, 1e-3),
                         [](const auto& info) { return "Micrometres" + std::to_string(std::lround(info.param * 1e6)); });

TEST(FclHull, NearestPointsLieOnTheBodies) {
  const ConvexHull cube = boxHull({1, 1, 1}), other = boxHull({0.5, 0.5, 0.5});
  const Eigen::Isometry3d pose = cornerTo(0.25, 1);
  const FclAnswer answer = fclDistance(FclHull(cube), FclHull(other), pose);
  EXPECT_LT((answer.on_first - Vector3d(0.5, 0.0712, -0.0391)).norm(), 1e-6);
  EXPECT_LT((answer.on_second - Vector3d(0.75, 0.0712, -0.0391)).norm(), 1e-6);
  EXPECT_TRUE(proved(answer, cube, transformed(other, pose), 1e-9));
}

TEST(FclQueries, APointMayCoincideWithACorner) {
  for (const Vector3d& sides : {Vector3d(1, 1, 1), Vector3d(0.125, 0.75, 0.5), Vector3d(1, 0.006, 0.002)}) {
    const ConvexHull box = boxHull(sides);
    const FclHull hull(box);
    const FclMesh mesh(surface(box));
    for (const Vector3d& corner : box.vertices) {
      EXPECT_EQ(fclDistance(hull, corner).distance, 0);
      EXPECT_EQ(fclDistance(hull, 2 * corner).status, Status::kDistance);
      EXPECT_NEAR(fclDistance(hull, 2 * corner).distance, corner.norm(), kFclTolerance);
      EXPECT_NEAR(fclDistance(mesh, corner).distance, 0, kFclTolerance);
    }
  }
}

/// A box with corners on a grid of eighths: faces, edges and corners of two such boxes often line up.
Eigen::AlignedBox3d gridBox(Random& random) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t low = random.below(8);
    box.min()[axis] = static_cast<double>(low) / 8;
    box.max()[axis] = static_cast<double>(low + 1 + random.below(8 - low)) / 8;
  }
  return box;
}

ConvexHull hullOf(const Eigen::AlignedBox3d& box) {
  return convexHull(test_shapes::moved(test_shapes::box(box.sizes().x(), box.sizes().y(), box.sizes().z()), box.min()).vertices);
}

// FCL's answers about hulls with aligned faces are off by as much as the hulls' size in one pair of a hundred; none of these may count as
// proved.
TEST(FclQueries, WrongAnswersAboutAlignedBoxesAreNeverProved) {
  Random random(1, 0, 0);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::AlignedBox3d first = gridBox(random), second = gridBox(random);
    const ConvexHull a = hullOf(first), b = hullOf(second);
    const double truth = first.exteriorDistance(second);
    const FclAnswer answer = fclDistance(FclHull(a), FclHull(b), Eigen::Isometry3d::Identity());
    const bool right = answer.status == Status::kDistance && std::abs(answer.distance - truth) <= kFclTolerance;
    EXPECT_TRUE(right || !proved(answer, a, b, 1e-12)) << "pair " << i << ": FCL " << answer.distance << ", truth " << truth;
    EXPECT_NEAR(bodyDistance(a, b), truth, 1e-12) << "pair " << i;
    const bool nested = first.contains(second) || second.contains(first);
    if (!nested) {
      EXPECT_NEAR(fclDistance(FclMesh(surface(a)), FclMesh(surface(b)), Eigen::Isometry3d::Identity()).distance, truth, 1e-12)
          << "pair " << i;
    }
  }
}

TEST(FclQueries, DetectsOverlapsOfSmallBodies) {
  // Cubes of a thousandth of the unit: unless they are enlarged, FCL calls about one overlap in fifteen separated.
  const ConvexHull cube = boxHull(Vector3d::Constant(1e-3));
  const FclHull fcl(cube);
  Random random(3, 0, 0);
  for (int i = 0; i < 1000; ++i) {
    Eigen::Isometry3d pose(random.rotation());
    pose.translation() = random.direction() * random.uniform(0, 2e-3);
    EXPECT_NEAR(fclDistance(fcl, fcl, pose).distance, bodyDistance(cube, transformed(cube, pose)), 1e-9) << "seed 3, query " << i;
  }
}

TEST(FclQueries, AgreesWithOurOwnDistances) {
  const std::vector<ProbeShape> shapes = boxShapes();
  const TriangleMesh original = test_shapes::moved(test_shapes::torus(0.35, 0.12, 16, 8), Vector3d(0.01, 0, 0));
  const ConvexHull hull = convexHull(original.vertices);
  const std::vector<ConvexHull> hulls{hull};
  const FclMesh mesh(original);
  const FclHull convex(hull);
  const PoseSampler sampler(original, hulls);
  for (std::uint64_t query = 0; query < 300; ++query) {
    SCOPED_TRACE("seed 7, query " + std::to_string(query));
    Random random(7, 0, query);
    const ProbeShape& shape = shapes[random.below(shapes.size())];
    const Probe probe = placed(shape, sampler.pose(random, shape.hull));
    EXPECT_NEAR(fclDistance(mesh, shape.mesh, probe.pose).distance, distanceToBody(original, probe.body), 1e-9);
    EXPECT_NEAR(fclDistance(convex, shape.convex, probe.pose).distance, bodyDistance(hull, probe.body), kFclTolerance);
    EXPECT_NEAR(fclDistance(convex, probe.centre).distance, pointDistance(hull, probe.centre), kFclTolerance);
  }
}

}  // namespace
}  // namespace collision_hulls
