// Bodies and worlds in the physics engine DART. Only this room uses it.
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

/// How the engine gets hulls: as convex bodies, for Bullet's collision detector, or as triangle meshes, as DART's URDF loader makes them
/// from files, for FCL's.
enum class Way { kConvex, kMesh };
const char* name(Way way);  ///< "convex", "mesh"
std::optional<Way> wayNamed(const std::string& name);

constexpr double kEarth = 9.81;     // [m/s^2]
constexpr double kTimeStep = 1e-3;  // [s]

dart::simulation::WorldPtr newWorld(Way way, const Eigen::Vector3d& gravity);

/// The convex hull of points. Only Bullet's detector supports it.
dart::dynamics::ShapePtr convexShape(const std::vector<Eigen::Vector3d>& points);

/// The mesh in a file. Throws kNotAMesh if DART cannot read it.
dart::dynamics::ShapePtr meshShape(const std::string& file);

void addShape(const dart::dynamics::ShapePtr& shape, double friction, dart::dynamics::BodyNode& body);

/// A body that moves freely.
dart::dynamics::BodyNode* addBody(dart::simulation::World& world, const std::string& name, const MassProperties& mass, double kilograms,
                                  const Eigen::Isometry3d& pose);

/// The table's top is z = 0. Convex bodies stand on a plane; meshes stand on a box of the given width and thickness, since DART's FCL
/// detector has no plane for meshes.
void addTable(dart::simulation::World& world, Way way, double friction, double width, double thickness);

}  // namespace collision_hulls
