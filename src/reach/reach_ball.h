// Roughly where a link can get, at no cost: enough to set aside what is far from a robot.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_hulls/robot/kinematics.h"

namespace collision_hulls {

/// A ball in the root link's frame that holds a link for all values of its joints. No joint moves its centre.
struct ReachBall {
  Eigen::Vector3d centre;
  double radius;  // [m]
};

/// `radius` [m]: no point of the link is further from the origin of its frame.
ReachBall reachBall(const Chain& chain, const std::vector<JointVariable>& variables, double radius);

}  // namespace collision_hulls
