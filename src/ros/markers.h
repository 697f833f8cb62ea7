// What rviz draws, as plain markers: pure functions from results to messages. View publishes them.
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

using MarkerList = std::vector<visualization_msgs::Marker>;

/// Everything drawn of a robot, one list per display. Markers are in their link's frame and locked to it, except those of the scene, which
/// are in the root link's frame. The namespace is `<kind>/<link>`; ids count from 0 within a namespace.
struct Drawing {
  MarkerList hulls;       ///< hulls/: a TRIANGLE_LIST per hull; primitives/: boxes, spheres and cylinders
  MarkerList original;    ///< original/: a mesh as it was read, or a primitive; grey
  MarkerList protrusion;  ///< worst/: sphere and arrow at the place of largest protrusion, and its size as text
  MarkerList labels;      ///< labels/: "forearm: 5 hulls, 4.8 mm", with a line to the link
  MarkerList unneeded;    ///< unneeded/: grey, finer hulls that a scene did not need
  MarkerList scene;       ///< scene: one TRIANGLE_LIST of all bodies
};

/// A sphere around the robot with all joints at zero, in the root link's frame.
struct RobotBounds {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;  ///< [m]
  double top = 0;     ///< [m] largest z
};

/// The file that the URI of a mesh means; throws Error where it means none.
using MeshFile = std::function<std::string(const std::string& uri)>;

/// The bounds of the elements that `source` selects. Reads their meshes; a mesh that cannot be read counts as the point of its origin.
RobotBounds robotBounds(const RobotDescription& robot, Source source, const MeshFile& file);

/// The original alone, before anything is computed: each mesh as a MESH_RESOURCE, which rviz reads itself, and the primitives.
Drawing drawOriginal(const RobotDescription& robot, Source source, const MeshFile& file);

/// A result, the description that it was made from (for the primitives among the originals), and the scene that it was fitted to (null:
/// none). `opacity` is that of the hulls, in [0, 1].
Drawing drawResult(const RobotResult& result, const RobotDescription& original, const Scene* scene, double opacity);

/// A colour for each link: hues spread by the golden ratio, so that neighbours in the list differ most.
double linkHue(std::size_t link);

/// A shade of a link's hue for its n-th hull. Shades repeat after seven hulls.
std_msgs::ColorRGBA shade(double hue, std::size_t hull, double opacity);

/// The state of a run, above the robot.
visualization_msgs::Marker drawProgress(const std::string& text, const std::string& frame, const RobotBounds& bounds);

}  // namespace collision_hulls
