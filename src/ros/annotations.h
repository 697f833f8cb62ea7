// What is written and pointed at beside the shapes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pen.h"
#include "robot_bounds.h"

namespace collision_hulls {

/// A mesh of a link, and how well its hulls fit.
struct LinkMesh {
  const ElementResult& element;
  const ElementReport& row;
};

/// What a link is drawn from. `meshes` is in the order of the result.
struct Link {
  std::string name;
  double hue = 0;
  std::vector<LinkMesh> meshes;
  std::size_t hulls = 0, primitives = 0;
};

/// Sphere and arrow at the place of a link's largest protrusion, and its size as text. `hulls`: all of the robot, in the root link's frame,
/// which the arrow avoids.
void drawWorst(const Link& link, double radius, const std::vector<ConvexHull>& hulls, Pen& pen, MarkerList& list);

/// A link's label and what it belongs to, in the root link's frame.
struct Label {
  const Link* link = nullptr;
  Eigen::Isometry3d link_pose = Eigen::Isometry3d::Identity();
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero(), place = Eigen::Vector3d::Zero();
};

Label labelOf(const Link& link, const LinkDescription& description);

/// Labels in columns to the left and right of the robot, where none hides another.
void drawLabels(std::vector<Label> labels, const RobotBounds& robot, Pen& pen, MarkerList& list);

/// The state of a run, above the robot.
visualization_msgs::Marker drawProgress(const std::string& text, const std::string& frame, const RobotBounds& bounds);

}  // namespace collision_hulls
