// What urdfdom makes of a description. The only place that sees urdfdom.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// A description as urdfdom reads it: links in the order of their names, poses set.
struct UrdfModel {
  std::string name;
  std::vector<LinkDescription> links;
  std::vector<JointDescription> joints;  ///< as in RobotDescription
  std::string complaints;                ///< errors that urdfdom logged though it took the description, "; " between them
};

/// Reads a URDF whose root is <robot> and whose joints form no loop (checkJointGraph). urdfdom drops the rest of a link after an element
/// that it cannot read and says so in its log only: compare the numbers of elements. Throws std::runtime_error with urdfdom's reason.
/// Not thread safe: a worker of the reader program has one thread.
UrdfModel readUrdfModel(const std::string& urdf_text);

}  // namespace collision_hulls
