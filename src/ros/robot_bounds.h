// How large a robot is, for its camera and its texts.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// A sphere around the robot, in the root link's frame.
struct RobotBounds {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;  ///< [m]
  double top = 0;     ///< [m] largest z
};

/// The file that the URI of a mesh means; throws Error where it means none.
using MeshFile = std::function<std::string(const std::string& uri)>;

struct MeshReading {
  MeshFile file;
  MeshLimits limits = {};
  const RunControl& control;
};

/// The bounds of the elements that `source` selects, with joints where joint_state_publisher first puts them: at zero, or in the middle of
/// limits that exclude it. Reads their meshes; a mesh that cannot be read counts as the point of its origin. Throws kCancelled.
RobotBounds robotBounds(const RobotDescription& robot, Source source, const MeshReading& reading);

/// The bounds of a result's original meshes, with all joints at zero.
RobotBounds robotBounds(const RobotResult& result);

/// The name of the link without a parent; empty: there is none.
std::string rootLink(const RobotDescription& robot);

/// Whether an element is a box, a sphere or a cylinder.
bool isPrimitive(const GeometryElement& element);

/// The box about a primitive, in its own frame.
Eigen::AlignedBox3d localBox(const GeometryElement& element);

/// The box about a box that is moved.
Eigen::AlignedBox3d moved(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& pose);

/// The box of an element's original in the root link's frame.
Eigen::AlignedBox3d rootBox(const ElementResult& element);

}  // namespace collision_hulls
