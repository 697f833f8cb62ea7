#include "primitives/tolerable_space.h"

#include <gtest/gtest.h>

#include "octahedron.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

/// A block with a groove of this width along its top, half as deep as the block.
TriangleMesh grooved(double width) {
  return uChannel(1, 1, (1 - width) / 2, 1);
}

TEST(TolerableSpace, NoPointOfABallIsBeyondTheTolerance) {
  RandomPoints random(1);
  for (const TriangleMesh& mesh :
       {lBracket(), flask(), torus(), sheet(), grooved(0.05), merged({box(1, 1, 1), moved(box(1, 1, 1), {0.5, 0, 0})})}) {
    const Solid solid = solidOf(mesh);
    const double tolerance = 0.05;
    const TolerableSpace space(solid, boundingBox(mesh), tolerance, {});
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d centre = box.center() + 1.2 * (random.inBox(box) - box.center());
      const double radius = space.radius(centre);
      for (int k = 0; k < 50 && radius > 0; ++k)
        EXPECT_LE(solid.distance(centre + radius * std::cbrt(random.number(0, 1)) * random.onSphere()), tolerance * (1 + 1e-9));
      for (int k = 0; k < 50 && radius > 0; ++k) EXPECT_LE(solid.distance(centre + radius * random.onSphere()), tolerance * (1 + 1e-9));
    }
  }
}

TEST(TolerableSpace, BesideAFlatWallTheBallIsExact) {
  const Solid solid = solidOf(box(1, 1, 1));
  const TolerableSpace space(solid, Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()), 0.1, {});
  EXPECT_NEAR(space.radius({0.5, 0.5, 0.5}), 0.6, 1e-6);
  EXPECT_NEAR(space.radius({0.5, 0.5, 0.2}), 0.3, 1e-6);
  EXPECT_NEAR(space.radius({0.5, 0.5, 1.04}), 0.06, 1e-6);
  EXPECT_LE(space.radius({0.5, 0.5, 1.2}), 0);
}

/// The summit is a corner of eight cubes of the octree.
TEST(TolerableSpace, ASummitAtTheCornersOfCubesIsOutsideIfItIsBeyondTheTolerance) {
  for (const double distance : {0.0999, 0.101}) {
    const TriangleMesh mesh = octahedronOfSheets(distance);
    const Solid solid = solidOf(mesh);
    ASSERT_NEAR(solid.distance({0, 0, 0}), distance, 1e-12);
    const double radius = TolerableSpace(solid, boundingBox(mesh), 0.1, {}).radius({0, 0, 0});
    EXPECT_EQ(radius > 1e-3, distance < 0.1) << radius;
  }
}

TEST(TolerableSpace, BallsReachAcrossNarrowGroovesAndWallsInside) {
  const TriangleMesh groove = grooved(0.05), boxes = merged({box(1, 1, 1), moved(box(1, 1, 1), {0.5, 0, 0})});
  for (const TriangleMesh& mesh : {groove, boxes}) {
    const Solid solid = solidOf(mesh);
    const TolerableSpace space(solid, boundingBox(mesh), 0.1, {});
    const Eigen::Vector3d middle = boundingBox(mesh).center();
    EXPECT_GT(space.radius(middle), 0.5) << "by distance alone: " << 0.1 + solid.distanceToSurface(middle);
  }
}

TEST(TolerableSpace, BoundsItsOwnBallsAndNoOthers) {
  const Solid solid = solidOf(lBracket());
  const TolerableSpace space(solid, boundingBox(lBracket()), 0.1, {});
  const Eigen::Vector3d centre(0.4, 0.05, 0.5);
  const double radius = space.radius(centre);
  EXPECT_LE(space.bound({centre, radius}), 0.1 * (1 + 1e-12));
  EXPECT_NEAR(space.bound({centre, 0.1}), 0.05, 1e-6);
  EXPECT_TRUE(std::isinf(space.bound({centre, radius + 0.001})));
}

}  // namespace
}  // namespace collision_hulls
