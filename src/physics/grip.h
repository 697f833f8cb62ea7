// The demo robot's gripper closes on a box between its hooked fingers and lifts it.
#pragma once

#include <dart/dynamics/Skeleton.hpp>
#include <string>

namespace collision_hulls {

struct GripResult {
  std::string outcome = "held";  ///< held; lost: the box slipped out
  std::size_t hulls = 0;         ///< of both fingers
  double slip = 0;               ///< [m] way of the box once it has its weight; where it was lost, up to the end
  double turn = 0;               ///< [rad] of the box
  double opening = 0;            ///< [m] between where the fingertips are when the gripper has closed
  double step_us = 0;            ///< [us] median of a step of the engine
};

/// The gripper points down, with the fingers of `robot` as convex bodies, each pressed against the box by a constant force. The box is
/// too heavy for friction alone: it stays only if the hooks reach under it. Throws kNotARobot where joints or links of the gripper lack.
GripResult grip(const dart::dynamics::SkeletonPtr& robot);

}  // namespace collision_hulls
