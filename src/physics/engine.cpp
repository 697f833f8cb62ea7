// Thin wrappers around DART that choose its collision detector: Bullet's for convex bodies, FCL's for triangle meshes.
#include "physics/engine.h"

#include <dart/collision/bullet/BulletCollisionDetector.hpp>
#include <dart/collision/fcl/FCLCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/MeshShape.hpp>
#include <dart/dynamics/MultiSphereConvexHullShape.hpp>
#include <dart/dynamics/PlaneShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>

#include "collision_hulls/error.h"

namespace collision_hulls {

namespace dd = dart::dynamics;

const char* name(Way way) {
  return way == Way::kConvex ? "convex" : "mesh";
}

std::optional<Way> wayNamed(const std::string& text) {
  for (const Way way : {Way::kConvex, Way::kMesh})
    if (text == name(way)) return way;
  return std::nullopt;
}

dart::simulation::WorldPtr newWorld(Way way, const Eigen::Vector3d& gravity) {
  dart::simulation::WorldPtr world = dart::simulation::World::create();
  world->setTimeStep(kTimeStep);
  world->setGravity(gravity);
  if (way == Way::kConvex) {
    world->getConstraintSolver()->setCollisionDetector(dart::collision::BulletCollisionDetector::create());
  } else {
    world->getConstraintSolver()->setCollisionDetector(dart::collision::FCLCollisionDetector::create());
  }
  return world;
}

// DART has no shape for the hull of points, but one for the hull of spheres; spheres of radius 0 are points.
dd::ShapePtr convexShape(const std::vector<Eigen::Vector3d>& points) {
  dd::MultiSphereConvexHullShape::Spheres spheres;
  for (const Eigen::Vector3d& p : points) spheres.emplace_back(0, p);
  return std::make_shared<dd::MultiSphereConvexHullShape>(spheres);
}

dd::ShapePtr meshShape(const std::string& file) {
  const aiScene* scene = dd::MeshShape::loadMesh(file);
  if (!scene)
    throw Error(ErrorCode::kNotAMesh,
                "'" + file + "': DART cannot read this mesh file; give a format that DART supports, such as STL or DAE");
  return std::make_shared<dd::MeshShape>(Eigen::Vector3d::Ones(), scene);
}

void addShape(const dd::ShapePtr& shape, double friction, dd::BodyNode& body) {
  dd::ShapeNode* const node = body.createShapeNodeWith<dd::CollisionAspect, dd::DynamicsAspect>(shape);
  node->getDynamicsAspect()->setFrictionCoeff(friction);
}

dd::BodyNode* addBody(dart::simulation::World& world, const std::string& name, const MassProperties& mass, double kilograms,
                      const Eigen::Isometry3d& pose) {
  const dd::SkeletonPtr skeleton = dd::Skeleton::create(name);
  const auto [joint, body] = skeleton->createJointAndBodyNodePair<dd::FreeJoint>();
  body->setInertia(dd::Inertia(kilograms, mass.center, kilograms * mass.inertia));
  joint->setPositions(dd::FreeJoint::convertToPositions(pose));
  world.addSkeleton(skeleton);
  return body;
}

void addTable(dart::simulation::World& world, Way way, double friction, double width, double thickness) {
  const dd::SkeletonPtr skeleton = dd::Skeleton::create("table");
  const auto [joint, body] = skeleton->createJointAndBodyNodePair<dd::WeldJoint>();
  if (way == Way::kConvex) {
    addShape(std::make_shared<dd::PlaneShape>(Eigen::Vector3d::UnitZ(), 0.0), friction, *body);
  } else {
    Eigen::Isometry3d lowered = Eigen::Isometry3d::Identity();
    lowered.translation().z() = -thickness / 2;
    joint->setTransformFromParentBodyNode(lowered);
    addShape(std::make_shared<dd::BoxShape>(Eigen::Vector3d(width, width, thickness)), friction, *body);
  }
  world.addSkeleton(skeleton);
}

}  // namespace collision_hulls
