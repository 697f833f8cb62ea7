// Waits for ROS by the steady clock: simulated time may stand still, and the wall clock may be set.
#pragma once

#include <ros/ros.h>

#include <chrono>
#include <functional>
#include <future>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// Polls `done` for at most `seconds`. Returns whether it became true; false also when ROS shuts down. Throws kCancelled.
inline bool waitFor(const std::function<bool()>& done, double seconds, const RunControl& control) {
  const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(seconds);
  while (ros::ok()) {
    if (done()) return true;
    if (ros::SteadyTime::now() >= end) return false;
    control.check();
    ros::WallDuration(0.02).sleep();
  }
  return false;
}

enum class Called { kAnswered, kFailed, kLate };

/// Calls a service for at most `seconds`. `client` must be persistent: roscpp ends a call early only with its connection. Throws
/// kCancelled.
template <class Service>
Called callInTime(ros::ServiceClient& client, Service& call, double seconds, const RunControl& control) {
  std::future<bool> answer = std::async(std::launch::async, [&] { return client.call(call); });
  const auto has_ended = [&] { return answer.wait_for(std::chrono::milliseconds(0)) == std::future_status::ready; };
  const auto end = [&] {
    while (answer.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
      client.shutdown();  // once does not end one that is about to begin
  };
  try {
    if (waitFor(has_ended, seconds, control)) return answer.get() ? Called::kAnswered : Called::kFailed;
  } catch (...) {
    end();
    throw;
  }
  end();
  return Called::kLate;
}

}  // namespace collision_hulls
