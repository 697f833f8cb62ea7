// A box that DART moves in and out of a mouth that a region keeps clear.
#include <gtest/gtest.h>

#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <memory>

#include "collision_hulls/decompose/certified_hulls.h"
#include "physics/engine.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

/// Jaws 1.6 apart and 1.8 long, which open along +y. The box stays 0.1 away from them: Bullet takes hulls for 0.04 larger than they are.
TriangleMesh gripper() {
  return test_shapes::uChannel(2, 2, 0.2, 1);
}
const Eigen::Vector3d kBox(1.4, 1.6, 0.9), kInside(1, 1.2, 0.5);

std::vector<ConvexHull> hullsWith(const std::vector<Region>& regions) {
  DecomposeOptions options;
  options.tolerance = 1;
  options.regions = regions;
  return certifiedHulls(gripper(), options).hulls;
}

/// In how many of 30 steps from outside to the inside the box touches a hull.
int contacts(const std::vector<ConvexHull>& hulls) {
  const auto world = newWorld(Way::kConvex, Eigen::Vector3d::Zero());
  const MassProperties mass = massProperties(convexHull(gripper().vertices));
  dart::dynamics::BodyNode* const model = addBody(*world, "gripper", mass, 1, Eigen::Isometry3d::Identity());
  for (const ConvexHull& hull : hulls) addShape(convexShape(hull.vertices), 0.5, *model);
  dart::dynamics::BodyNode* const box = addBody(*world, "box", mass, 1, Eigen::Isometry3d::Identity());
  addShape(std::make_shared<dart::dynamics::BoxShape>(kBox), 0.5, *box);
  int count = 0;
  for (int step = 0; step < 30; ++step) {
    const Eigen::Isometry3d place(Eigen::Translation3d(kInside + Eigen::Vector3d(0, 0.1 * step, 0)));
    dynamic_cast<dart::dynamics::FreeJoint&>(*box->getParentJoint()).setTransform(place);
    count += world->checkCollision(world->getConstraintSolver()->getCollisionOption());  // but for shapes of one body
  }
  return count;
}

TEST(Regions, ABoxGoesInAndOutOfAMouthThatIsKeptClear) {
  EXPECT_GT(contacts(hullsWith({})), 10) << "one hull fills the mouth";
  const Eigen::Isometry3d pose(Eigen::Translation3d(kInside + Eigen::Vector3d(0, 1.5, 0)));
  EXPECT_EQ(contacts(hullsWith({boxRegion({1.4, 4.6, 3}, pose, kRegionSlack)})), 0);
}

}  // namespace
}  // namespace collision_hulls
