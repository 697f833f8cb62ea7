// What the master knows of a topic.
#pragma once

#include <ros/master.h>

#include <algorithm>
#include <optional>
#include <string>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Before a topic's name, where the source of something may be a topic.
inline const std::string kTopicPrefix = "topic:";

/// The type of the topic's messages; nothing: nobody publishes it. Throws kBadOption where the master does not answer.
inline std::optional<std::string> typeOfTopic(const std::string& name) {
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics))
    throw Error(ErrorCode::kBadOption,
                "the ROS master at " + ros::master::getURI() + " does not answer: start roscore, or set ROS_MASTER_URI");
  const auto topic = std::find_if(topics.begin(), topics.end(), [&](const auto& info) { return info.name == name; });
  return topic == topics.end() ? std::nullopt : std::optional(topic->datatype);
}

}  // namespace collision_hulls
