// The fingers are rebuilt as free-standing skeletons on prismatic joints, driven by constant forces and coupled like a geared gripper. For
// one second the gripper closes on a box that floats; then the box gets its weight, and its slip is measured for two.
#include "physics/grip.h"

#include <assimp/scene.h>

#include <chrono>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/DegreeOfFreedom.hpp>
#include <dart/dynamics/MeshShape.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>

#include "base/median.h"
#include "collision_hulls/error.h"
#include "physics/engine.h"

namespace collision_hulls {
namespace {

namespace dd = dart::dynamics;

// Bullet rounds bodies off by some hundredths of a unit, so the unit is the centimetre.
constexpr double kUnit = 100;                                     // per metre
const Eigen::Vector3d kBox(0.030, 0.040, 0.020);                  // [m] 40 mm wide between the fingers, at the arms behind the hooks
const Eigen::Vector3d kBoxPlace(0.082, 0, 0);                     // [m] in the gripper's frame
constexpr double kBoxMass = 1.5, kFingerMass = 0.115;             // [kg]
constexpr double kForce = 20, kFingerFriction = 0.2;              // [N] per finger; friction alone holds 0.8 kg
constexpr double kClosing = 1, kHolding = 2;                      // [s]
constexpr double kLost = 0.015;                                   // [m] half the box
constexpr double kDamping = 20, kEven = 4e4, kEvenDamping = 400;  // [1/s], [1/s^2], [1/s]; kEven couples the fingers
constexpr double kRecovery = 0.05;                                // [m/s] at which overlaps are resolved

std::vector<Eigen::Vector3d> pointsOf(const dd::ShapeNode& node, const Eigen::Isometry3d& pose) {
  std::vector<Eigen::Vector3d> points;
  const auto* const shape = dynamic_cast<const dd::MeshShape*>(node.getShape().get());
  if (!shape)
    throw Error(ErrorCode::kNotARobot,
                "'" + node.getName() + "': the collision model of a finger must consist of meshes; use a method that makes hulls");
  for (unsigned m = 0; m < shape->getMesh()->mNumMeshes; ++m) {
    const aiMesh& mesh = *shape->getMesh()->mMeshes[m];
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const Eigen::Vector3d p(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
      points.push_back(kUnit * (pose * node.getRelativeTransform() * p.cwiseProduct(shape->getScale())));
    }
  }
  return points;
}

/// Adds a finger as a skeleton of its own, of convex bodies in the gripper's frame.
dd::DegreeOfFreedom* addFinger(const dd::SkeletonPtr& robot, const std::string& side, dart::simulation::World& world, std::size_t& hulls) {
  dd::BodyNode* const gripper = robot->getBodyNode("gripper_link");
  dd::BodyNode* const finger = robot->getBodyNode(side + "_finger_link");
  const auto* const given = dynamic_cast<dd::PrismaticJoint*>(robot->getJoint(side + "_finger_joint"));
  if (!gripper || !finger || !given)
    throw Error(ErrorCode::kNotARobot, "'" + robot->getName() + "' has no gripper_link with a prismatic " + side +
                                           "_finger_joint; give --grip the demo robot, or one with the same gripper");
  const Eigen::Isometry3d pose = finger->getTransform(gripper);
  const dd::SkeletonPtr skeleton = dd::Skeleton::create(side);
  const auto [joint, body] = skeleton->createJointAndBodyNodePair<dd::PrismaticJoint>();
  joint->setAxis(pose.linear() * given->getAxis());
  joint->setPositionLowerLimit(0, kUnit * given->getPositionLowerLimit(0));
  joint->setPositionUpperLimit(0, kUnit * given->getPositionUpperLimit(0));
  joint->setLimitEnforcement(true);
  body->setInertia(dd::Inertia(kFingerMass, Eigen::Vector3d::Zero(), kFingerMass * Eigen::Matrix3d::Identity()));
  body->setGravityMode(false);
  for (dd::ShapeNode* const node : finger->getShapeNodesWith<dd::CollisionAspect>()) {
    addShape(convexShape(pointsOf(*node, pose)), kFingerFriction, *body);
    ++hulls;
  }
  world.addSkeleton(skeleton);
  return joint->getDof(0);
}

dd::BodyNode* addBox(dart::simulation::World& world) {
  const auto shape = std::make_shared<dd::BoxShape>(kUnit * kBox);
  const MassProperties mass{Eigen::Vector3d::Zero(), shape->computeInertia(1.0)};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = kUnit * kBoxPlace;
  dd::BodyNode* const box = addBody(world, "box", mass, kBoxMass, pose);
  addShape(shape, kFingerFriction, *box);
  box->setGravityMode(false);
  return box;
}

/// Applies the closing forces; a stiff coupling stands in for the gear that moves both fingers alike.
void press(dd::DegreeOfFreedom& left, dd::DegreeOfFreedom& right) {
  const double apart = kEven * (left.getPosition() - right.getPosition()) + kEvenDamping * (left.getVelocity() - right.getVelocity());
  left.setCommand(kUnit * kForce - kFingerMass * (apart + kDamping * left.getVelocity()));
  right.setCommand(kUnit * kForce + kFingerMass * (apart - kDamping * right.getVelocity()));
}

}  // namespace

GripResult grip(const dd::SkeletonPtr& robot) {
  GripResult result;
  const dart::simulation::WorldPtr world = newWorld(Way::kConvex, {kUnit * kEarth, 0, 0});
  dart::constraint::ContactConstraint::setMaxErrorReductionVelocity(kUnit * kRecovery);
  dd::DegreeOfFreedom* const left = addFinger(robot, "left", *world, result.hulls);
  dd::DegreeOfFreedom* const right = addFinger(robot, "right", *world, result.hulls);
  dd::BodyNode* const box = addBox(*world);
  Eigen::Isometry3d closed = box->getWorldTransform();
  std::vector<double> steps;
  for (double time = 0; time < kClosing + kHolding; time += kTimeStep) {
    if (time >= kClosing && !box->getGravityMode()) {
      closed = box->getWorldTransform();
      result.opening =
          (left->getPositionUpperLimit() - left->getPosition() + right->getPositionUpperLimit() - right->getPosition()) / kUnit;
      box->setGravityMode(true);
    }
    press(*left, *right);
    const auto start = std::chrono::steady_clock::now();
    world->step();
    steps.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  const Eigen::Isometry3d moved = closed.inverse() * box->getWorldTransform();
  result.slip = moved.translation().norm() / kUnit;
  result.turn = Eigen::AngleAxisd(moved.linear()).angle();
  if (!(result.slip < kLost)) result.outcome = "lost";
  result.step_us = median(steps);
  return result;
}

}  // namespace collision_hulls
