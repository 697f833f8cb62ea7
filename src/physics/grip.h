// The demo robot's gripper closes on a box between its hooked fingers and holds it against gravity.
#pragma once

#include <dart/dynamics/Skeleton.hpp>
#include <string>

namespace collision_hulls {

struct GripResult {
  std::string outcome = "held";  ///< held; lost: the box slipped out
  std::size_t hulls = 0;         ///< of both fingers
  double slip = 0;               ///< [m] how far the box moves once it has its weight; if it is lost, until the end
  double turn = 0;               ///< [rad] how far the box turns
  double opening = 0;            ///< [m] distance of the fingertips once the gripper has closed
  double step_us = 0;            ///< [us] median time of an engine step
};

/// The gripper points down, with the fingers of `robot` as convex bodies, each pressed against the box by a constant force. The box is too
/// heavy for friction alone: it stays only if the hooks reach under it. Throws kNotARobot if joints or links of the gripper are missing.
GripResult grip(const dart::dynamics::SkeletonPtr& robot);

}  // namespace collision_hulls
