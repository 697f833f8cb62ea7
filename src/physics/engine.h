// Bodies and worlds of the physics engine DART. This room alone sees it.
#pragma once

#include <Eigen/Geometry>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>
#include <optional>
#include <string>
#include <vector>

#include "physics/resting.h"

namespace collision_hulls {

/// How the engine is given hulls: as convex bodies, which Bullet's detector takes, or as triangle meshes, which is what DART's URDF loader
/// makes of files, for FCL's.
enum class Way { kConvex, kMesh };
const char* name(Way way);  ///< "convex", "mesh"
std::optional<Way> wayNamed(const std::string& name);

constexpr double kEarth = 9.81;     // [m/s^2]
constexpr double kTimeStep = 1e-3;  // [s]

dart::simulation::WorldPtr newWorld(Way way, const Eigen::Vector3d& gravity);

/// The convex hull of points. Bullet's detector alone knows it.
dart::dynamics::ShapePtr convexShape(const std::vector<Eigen::Vector3d>& points);

/// What a mesh file holds. Throws kNotAMesh where DART cannot read it.
dart::dynamics::ShapePtr meshShape(const std::string& file);

void addShape(const dart::dynamics::ShapePtr& shape, double friction, dart::dynamics::BodyNode& body);

/// A body that moves freely.
dart::dynamics::BodyNode* addBody(dart::simulation::World& world, const std::string& name, const MassProperties& mass, double kilograms,
                                  const Eigen::Isometry3d& pose);

/// The table's top is z = 0. Convex bodies stand on a plane, meshes on a box of the given thickness, since FCL's meshes know no plane.
void addTable(dart::simulation::World& world, Way way, double friction, double width, double thickness);

}  // namespace collision_hulls
