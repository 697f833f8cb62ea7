// What joint_states.cpp and the program collision_hulls_bag_reader say to each other.
#pragma once

#include <string>
#include <vector>

#include "geometry/bytes.h"

namespace collision_hulls {

/// The part of a sensor_msgs/JointState that becomes a configuration.
struct RecordedState {
  std::vector<std::string> names;
  std::vector<double> positions;
};

template <typename Archive>
void fields(Archive& archive, RecordedState& state) {
  archive(state.names, state.positions);
}

constexpr const char* kJointStateType = "sensor_msgs/JointState";

}  // namespace collision_hulls
