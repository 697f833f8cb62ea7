// Waits for ROS by the wall clock, as simulated time may stand still.
#pragma once

#include <ros/ros.h>

#include <functional>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Polls `done` for at most `seconds`. Returns whether it became true; false also when ROS shuts down. Throws kCancelled.
inline bool waitFor(const std::function<bool()>& done, double seconds, const RunControl& control) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::ok()) {
    if (done()) return true;
    if (ros::WallTime::now() >= end) return false;
    control.check();
    ros::WallDuration(0.02).sleep();
  }
  return false;
}

}  // namespace collision_hulls
