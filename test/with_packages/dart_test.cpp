// DART loads what decompose writes: the description with its URDF loader, and the SKEL file of --for dart. Both make a triangle mesh of
// each hull, in which a ball comes to rest; and so it does in convex shapes, without Bullet's margin.
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <dart/collision/bullet/BulletCollisionDetector.hpp>
#include <dart/collision/bullet/BulletCollisionObject.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/MeshShape.hpp>
#include <dart/dynamics/MultiSphereConvexHullShape.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/simulation/World.hpp>
#include <dart/utils/SkelParser.hpp>
#include <map>

#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/robot/robot_description.h"
#include "physics/robot.h"
#include "with_packages/written.h"

namespace collision_hulls {
namespace {

namespace dd = dart::dynamics;

std::string only(const std::string& folder) {
  return std::filesystem::directory_iterator(folder)->path().string();
}

dart::simulation::WorldPtr worldOf(const std::string& out) {
  const dart::simulation::WorldPtr world = dart::utils::SkelParser::readWorld(dart::common::Uri::createFromPath(only(out + "/skel")));
  EXPECT_TRUE(world) << out;
  return world;
}

std::vector<Eigen::Vector3d> pointsOf(const dd::MeshShape& shape) {
  std::vector<Eigen::Vector3d> points;
  for (unsigned m = 0; m < shape.getMesh()->mNumMeshes; ++m) {
    const aiMesh& mesh = *shape.getMesh()->mMeshes[m];
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      points.push_back(shape.getScale().cwiseProduct(Eigen::Vector3d(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z)));
  }
  return points;
}

/// [m] By how much the two differ in the extent of a link's shapes along x, y, z, with the link where DART has it.
double difference(const dd::BodyNode& body, const LinkDescription& link, const std::string& out) {
  std::size_t i = 0;
  double largest = 0;
  for (const dd::ShapeNode* node : const_cast<dd::BodyNode&>(body).getShapeNodesWith<dd::CollisionAspect>()) {
    const GeometryElement& element = link.collisions.at(i++);
    if (element.kind != GeometryElement::Kind::kMesh) continue;
    const TriangleMesh mesh = readMesh(out + element.uri.substr(element.uri.find("/meshes/"))).mesh;
    const auto* const shape = dynamic_cast<const dd::MeshShape*>(node->getShape().get());
    EXPECT_NE(shape, nullptr) << link.name << ": a hull is " << node->getShape()->getType();
    if (!shape) return 1;
    Eigen::AlignedBox3d ours, theirs;
    for (const Eigen::Vector3d& v : mesh.vertices) ours.extend(element.origin * v);
    for (const Eigen::Vector3d& p : pointsOf(*shape)) theirs.extend(node->getRelativeTransform() * p);
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
  const std::string urdf = only(out + "/urdf");
  const dd::SkeletonPtr skeleton =
      loadRobot(fixtures::read(urdf), urdf, [&](const std::string&) { return std::optional<std::string>(out); });
  std::size_t shapes = 0;
  for (const dd::BodyNode* body : skeleton->getBodyNodes()) shapes += body->getNumShapeNodesWith<dd::CollisionAspect>();
  EXPECT_EQ(shapes, fixtures::collisions(urdf)) << urdf;
}

/// As doc/limits.md has it.
class BulletWithoutMargin : public dart::collision::BulletCollisionDetector {
 protected:
  std::unique_ptr<dart::collision::CollisionObject> createCollisionObject(const dd::ShapeFrame* frame) override {
    auto object = BulletCollisionDetector::createCollisionObject(frame);
    static_cast<dart::collision::BulletCollisionObject&>(*object).getBulletCollisionObject()->getCollisionShape()->setMargin(0);
    return object;
  }
};

/// Each mesh of a world's only skeleton becomes the hull of its points.
void makeConvex(dart::simulation::World& world) {
  for (dd::BodyNode* body : world.getSkeleton(0)->getBodyNodes()) {
    for (dd::ShapeNode* node : body->getShapeNodesWith<dd::CollisionAspect>()) {
      dd::MultiSphereConvexHullShape::Spheres points;
      for (const Eigen::Vector3d& p : pointsOf(dynamic_cast<const dd::MeshShape&>(*node->getShape()))) points.emplace_back(0, p);
      node->setShape(std::make_shared<dd::MultiSphereConvexHullShape>(points));
    }
  }
}

/// [m] where a ball of 2 cm radius comes to rest that falls along -y, above a robot that is held.
double restingHeight(dart::simulation::World& world) {
  world.setGravity({0, -9.81, 0});
  world.getSkeleton(0)->setMobile(false);
  const dd::SkeletonPtr ball = dd::Skeleton::create("ball");
  const auto [joint, body] = ball->createJointAndBodyNodePair<dd::FreeJoint>();
  const auto shape = std::make_shared<dd::SphereShape>(0.02);
  body->createShapeNodeWith<dd::CollisionAspect, dd::DynamicsAspect>(shape);
  body->setInertia(dd::Inertia(0.1, Eigen::Vector3d::Zero(), shape->computeInertia(0.1)));
  joint->setPositions(dd::FreeJoint::convertToPositions(Eigen::Isometry3d(Eigen::Translation3d(0.05, 0.15, 0.015))));
  world.addSkeleton(ball);
  for (int step = 0; step < 3000; ++step) world.step();
  return body->getWorldTransform().translation().y();
}

class Dart : public ::testing::Test {
 protected:
  dart::simulation::WorldPtr hook() {
    const std::string consumer = DEMO_ROBOT "/test/consumer";
    const std::string options = "-t 1mm --package-path 'collision_hulls_consumer=" + consumer + "' --quiet";
    const bool is_there =
        std::filesystem::exists(folder_ / "out") || fixtures::writeFor("dart", consumer + "/urdf/hook.urdf", folder_ / "out", options);
    return is_there ? worldOf(folder_ / "out") : nullptr;
  }

  fixtures::TempFolder folder_;
};

/// The hook's floor is 2 cm high and its prongs 8 cm.
TEST_F(Dart, ABallRestsInTheHookAsInTheOriginal) {
  const auto world = hook(), original = hook();
  ASSERT_TRUE(world && original);
  dd::BodyNode* const body = original->getSkeleton(0)->getBodyNode(0);
  body->removeAllShapeNodes();
  body->createShapeNodeWith<dd::CollisionAspect, dd::DynamicsAspect>(std::make_shared<dd::MeshShape>(
      Eigen::Vector3d::Ones(), dd::MeshShape::loadMesh(std::string(DEMO_ROBOT "/test/consumer/meshes/hook.obj"))));
  const double height = restingHeight(*world);
  EXPECT_NEAR(height, 0.04, 0.001);
  EXPECT_NEAR(height, restingHeight(*original), 0.001);
}

/// As they are, shapes of points are too thin for Bullet: doc/limits.md.
TEST_F(Dart, ABallRestsInConvexShapesWithoutBulletsMargin) {
  const auto world = hook(), with_margin = hook();
  ASSERT_TRUE(world && with_margin);
  makeConvex(*world);
  makeConvex(*with_margin);
  world->getConstraintSolver()->setCollisionDetector(std::make_shared<BulletWithoutMargin>());
  with_margin->getConstraintSolver()->setCollisionDetector(dart::collision::BulletCollisionDetector::create());
  EXPECT_NEAR(restingHeight(*world), 0.04, 0.001);
  EXPECT_GT(std::abs(restingHeight(*with_margin) - 0.04), 0.01) << "Bullet has changed, so that doc/limits.md need not warn";
}

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
    expectTheUrdfLoads(out);
  }
}

}  // namespace
}  // namespace collision_hulls
