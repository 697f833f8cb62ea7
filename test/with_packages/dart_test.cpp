// DART loads what decompose writes: the description with its URDF loader, which makes a triangle mesh of each hull, and the SKEL file of
// --for dart, in which hulls are convex and stand where the description has them.
#include <gtest/gtest.h>

#include <dart/collision/bullet/BulletCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/MultiSphereConvexHullShape.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>
#include <dart/utils/SkelParser.hpp>
#include <dart/utils/urdf/DartLoader.hpp>
#include <map>

#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/robot/robot_description.h"
#include "with_packages/written.h"

namespace collision_hulls {
namespace {

namespace dd = dart::dynamics;

std::size_t collisions(const RobotDescription& robot) {
  std::size_t count = 0;
  for (const LinkDescription& link : robot.links) count += link.collisions.size();
  return count;
}

std::string only(const std::string& folder) {
  return std::filesystem::directory_iterator(folder)->path().string();
}

dart::simulation::WorldPtr worldOf(const std::string& out) {
  static const auto bullet = dart::collision::BulletCollisionDetector::create();  // so that it is linked, and the file can name it
  const dart::simulation::WorldPtr world = dart::utils::SkelParser::readWorld(dart::common::Uri::createFromPath(only(out + "/skel")));
  EXPECT_TRUE(world) << out;
  return world;
}

/// [m] By how much the two differ in the extent of a link's shapes along x, y, z, with the link where DART has it.
double difference(const dd::BodyNode& body, const LinkDescription& link, const std::string& out) {
  std::size_t i = 0;
  double largest = 0;
  for (const dd::ShapeNode* node : const_cast<dd::BodyNode&>(body).getShapeNodesWith<dd::CollisionAspect>()) {
    const GeometryElement& element = link.collisions.at(i++);
    if (element.kind != GeometryElement::Kind::kMesh) continue;
    const TriangleMesh mesh = readMesh(out + element.uri.substr(element.uri.find("/meshes/"))).mesh;
    const auto* const shape = dynamic_cast<const dd::MultiSphereConvexHullShape*>(node->getShape().get());
    EXPECT_NE(shape, nullptr) << link.name << ": a hull is " << node->getShape()->getType();
    if (!shape) return 1;
    Eigen::AlignedBox3d ours, theirs;
    for (const Eigen::Vector3d& v : mesh.vertices) ours.extend(element.origin * v);
    for (const auto& [radius, p] : shape->getSpheres()) theirs.extend(node->getRelativeTransform() * p);
    largest = std::max({largest, (ours.min() - theirs.min()).norm(), (ours.max() - theirs.max()).norm()});
  }
  EXPECT_EQ(i, link.collisions.size()) << link.name;
  return largest;
}

/// Every link with its hulls, where it is when all joints are at zero.
void expectTheSame(const std::string& out) {
  const RobotDescription robot = readRobotDescription(only(out + "/urdf"));
  const dart::simulation::WorldPtr world = worldOf(out);
  ASSERT_TRUE(world && world->getNumSkeletons() == 1);
  EXPECT_EQ(world->getConstraintSolver()->getCollisionDetector()->getType(), "bullet");
  const dd::SkeletonPtr skeleton = world->getSkeleton(0);
  std::map<std::string, Eigen::Isometry3d> places;
  for (const LinkDescription& link : robot.links) places[link.name] = Eigen::Isometry3d::Identity();
  for (const JointDescription& joint : robot.joints) places[joint.child] = places[joint.parent] * joint.origin;
  skeleton->setPositions(Eigen::VectorXd::Zero(static_cast<int>(skeleton->getNumDofs())));
  for (const LinkDescription& link : robot.links) {
    const dd::BodyNode* const body = skeleton->getBodyNode(link.name);
    if (link.name == "world" && !body) continue;
    ASSERT_NE(body, nullptr) << link.name;
    EXPECT_LT((body->getWorldTransform().matrix() - places[link.name].matrix()).norm(), 1e-9) << link.name;
    EXPECT_LT(difference(*body, link, out), 1e-6) << link.name;
  }
}

/// What the description alone gives.
void expectTheUrdfLoads(const std::string& out) {
  const std::string urdf = only(out + "/urdf"), text = fixtures::read(urdf);
  const RobotDescription robot = readRobotDescription(urdf);
  const std::string bare =
      fixtures::withoutVisuals(text);  // which are in packages elsewhere, some mirrored: DART 6.12 ends the process for those
  dart::utils::DartLoader loader;
  loader.addPackageDirectory(std::filesystem::path(out).filename().string(), out);
  const dd::SkeletonPtr skeleton = loader.parseSkeletonString(bare, dart::common::Uri::createFromPath(urdf));
  ASSERT_TRUE(skeleton) << urdf;
  std::size_t shapes = 0;
  for (const dd::BodyNode* body : skeleton->getBodyNodes()) shapes += body->getNumShapeNodesWith<dd::CollisionAspect>();
  EXPECT_EQ(shapes, collisions(robot));
}

class Dart : public ::testing::Test {
 protected:
  fixtures::TempFolder folder_;
};

TEST_F(Dart, LoadsTheDemoRobot) {
  ASSERT_TRUE(fixtures::writeFor("dart", DEMO_ROBOT "/urdf/demo_arm.urdf", folder_ / "out",
                                 std::string("--package-path '" DEMO_ROBOT "' --no-validate --quiet")));
  expectTheSame(folder_ / "out");
  expectTheUrdfLoads(folder_ / "out");
}

TEST_F(Dart, LoadsTheSharedRobots) {
  if (fixtures::sharedRobots().empty()) GTEST_SKIP() << "no robots beside the repository";
  for (const std::string& robot : fixtures::sharedRobots()) {
    const std::string out = folder_ / std::filesystem::path(robot).filename().string();
    if (!fixtures::writeFor("dart", robot, out, fixtures::kQuick)) continue;
    expectTheSame(out);
  }
}

}  // namespace
}  // namespace collision_hulls
