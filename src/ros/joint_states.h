// Configurations from joint states, live or recorded.
#pragma once

#include <functional>
#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/scene/configurations.h"

namespace collision_hulls {

/// Whether a source names a topic ("topic:NAME" or "topic:NAME SECONDS") or a bag ("FILE.bag" or "FILE.bag TOPIC").
bool areJointStates(const std::string& source);

/// The configurations in the sensor_msgs/JointState messages of such a source: all that arrive within SECONDS (default 10), or all in the
/// bag, on TOPIC or on every topic. `path` turns FILE.bag into a path. Throws kBadOption for a malformed source, and for a topic that
/// nobody publishes or that has another type; kFileNotFound; kBadConfigurations for an unreadable bag or if there is no message;
/// kReaderFailed for a bag that crashes its reader, kOutOfMemory or kOutOfTime for one that exceeds its limits; what ConfigurationCollector
/// throws; kCancelled.
ConfigurationSet readJointStates(const std::string& source, const std::function<std::string(const std::string&)>& path,
                                 const Kinematics& kinematics, const ConfigurationOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
