// Simulates one drop: two seconds to settle, then a push with the speed that friction alone stops after kSlide. Lengths are in diagonals
// and energies in m g D, so that bodies of all sizes compare.
#include "physics/drop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <dart/collision/CollisionResult.hpp>
#include <dart/dynamics/BodyNode.hpp>

#include "base/median.h"

namespace collision_hulls {
namespace {

constexpr double kFriction = 0.5;
constexpr double kLift = 0.02;                                       // [D] above the table
constexpr double kMostTilt = 0.0873;                                 // [rad] 5 degrees, at the start
constexpr double kSettle = 2, kDriftFrom = 1.5, kPushed = 0.4;       // [s]
constexpr double kStill = 1e-6, kStillFor = 0.2;                     // [m g D] kinetic energy, [s]
constexpr double kWorstSinking = 0.01, kWorstEnergy = 0.1;           // [D], [m g D]
constexpr double kTableWidth = 20 * kBodySize, kTableThickness = 1;  // [m]

double lowest(const ConvexHull& hull, const Eigen::Isometry3d& pose) {
  double z = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& v : hull.vertices) z = std::min(z, (pose * v).z());
  return z;
}

/// The body in its world, observed step by step.
class Drop {
 public:
  Drop(const DropBody& body, Way way, const RestingPose& pose) : original_(body.original), down_(pose.rotation.row(2)), pose_(pose) {
    world_ = newWorld(way, {0, 0, -kEarth});
    addTable(*world_, way, kFriction, kTableWidth, kTableThickness);
    Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
    start.linear() = Eigen::AngleAxisd(std::min(kMostTilt, pose.stability / 2), Eigen::Vector3d(1, 1, 0).normalized()) * pose.rotation;
    start.translation().z() = kLift * kBodySize - lowest(original_, start);
    MassProperties mass = massProperties(original_);
    mass.center.setZero();
    body_ = addBody(*world_, "body", mass, 1, start);
    for (const auto& points : body.hulls) addShape(convexShape(points), kFriction, *body_);
    for (const std::string& file : body.files) addShape(meshShape(file), kFriction, *body_);
  }

  DropResult run() {
    wait(kDriftFrom);
    const Eigen::Vector3d before = place();
    wait(kSettle - kDriftFrom);
    result_.drift = (place() - before).norm() / kBodySize;
    result_.height = lowest(original_, body_->getWorldTransform()) / kBodySize;
    result_.tilt = std::acos(std::clamp(Eigen::Vector3d(body_->getWorldTransform().linear().row(2)).dot(down_), -1.0, 1.0));
    result_.contacts = world_->getLastCollisionResult().getNumContacts();
    result_.settle_seconds = still_since_ < 0 ? kSettle : still_since_;
    result_.step_us = medianStep();
    result_.outcome = outcome();
    if (result_.outcome != "fell" && result_.outcome != "unstable") push();
    return result_;
  }

 private:
  Eigen::Vector3d place() const { return body_->getWorldTransform().translation(); }

  void push() {
    const Eigen::Vector3d before = place();
    least_energy_ = std::numeric_limits<double>::infinity();
    Eigen::Vector6d velocity = Eigen::Vector6d::Zero();
    velocity[3] = std::sqrt(2 * kFriction * kEarth * kSlide * kBodySize);
    // DART gives a free joint's velocity in the body's frame.
    velocity.tail<3>() = body_->getWorldTransform().linear().transpose() * velocity.tail<3>();
    body_->getParentJoint()->setVelocities(velocity);
    wait(kPushed);
    result_.slide = (place() - before).head<2>().norm() / kBodySize;
    result_.outcome = outcome();
  }

  void wait(double seconds) {
    for (int i = 0; i < std::lround(seconds / kTimeStep); ++i) step();
  }

  void step() {
    const auto start = std::chrono::steady_clock::now();
    world_->step();
    steps_.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    const double unit = kEarth * kBodySize, kinetic = body_->computeKineticEnergy() / unit;
    const double energy = kinetic + place().z() / kBodySize;
    least_energy_ = std::min(least_energy_, energy);
    result_.energy = std::max(result_.energy, energy - least_energy_);
    result_.penetration = std::max(result_.penetration, -lowest(original_, body_->getWorldTransform()) / kBodySize);
    if (!(kinetic < kStill)) {
      still_since_ = -1;
    } else if (still_since_ < 0) {
      still_since_ = world_->getTime();
    }
  }

  double medianStep() const { return median({steps_.begin() + static_cast<std::ptrdiff_t>(steps_.size() / 2), steps_.end()}); }

  std::string outcome() const {
    if (!std::isfinite(result_.energy) || !place().allFinite() || result_.energy > kWorstEnergy) return "unstable";
    if (place().z() < -kBodySize) return "fell";
    if (result_.height < -kWorstSinking) return "sunk";
    if (result_.tilt > pose_.stability) return "tipped";
    return result_.settle_seconds > kSettle - kStillFor ? "moving" : "ok";
  }

  const ConvexHull& original_;
  const Eigen::Vector3d down_;
  const RestingPose pose_;
  dart::simulation::WorldPtr world_;
  dart::dynamics::BodyNode* body_ = nullptr;
  DropResult result_;
  std::vector<double> steps_;
  double least_energy_ = std::numeric_limits<double>::infinity();
  double still_since_ = -1;  // [s]
};

}  // namespace

DropResult drop(const DropBody& body, Way way, const RestingPose& pose) {
  return Drop(body, way, pose).run();
}

}  // namespace collision_hulls
