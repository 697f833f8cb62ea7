// Configurations from joint states that are published, or were recorded.
#pragma once

#include <functional>
#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/scene/configurations.h"

namespace collision_hulls {

/// Whether configurations are asked for by a topic, "topic:NAME" or "topic:NAME SECONDS", or by a bag, "FILE.bag" or "FILE.bag NAME".
bool areJointStates(const std::string& source);

/// The sensor_msgs/JointState messages of such a source: those that come within SECONDS (10 where it is not said), or those of a bag, on
/// the topic NAME or on all. `path` tells where FILE.bag is. Throws kBadOption for a source that is not understood, a topic that nobody
/// publishes or that has other messages, kFileNotFound, kBadConfigurations for a bag that cannot be read, or where no message came, and as
/// ConfigurationCollector does; kCancelled.
ConfigurationSet readJointStates(const std::string& source, const std::function<std::string(const std::string&)>& path,
                                 const Kinematics& kinematics, const ConfigurationOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
