// Scenes from topics and services: the master tells the type of the messages, which selects the reader. The message packages are optional;
// a source whose package was missing at build time gets an error that says so.
#include "live_scene.h"

#include <ros/callback_queue.h>
#include <ros/service.h>

#include <functional>
#include <map>

#include "collision_hulls/error.h"
#include "topic_type.h"
#include "waiting.h"
#ifdef COLLISION_HULLS_MOVEIT_MSGS
#include <moveit_msgs/GetPlanningScene.h>

#include "planning_scene.h"
#endif
#ifdef COLLISION_HULLS_OCTOMAP_MSGS
#include "octomap_message.h"
#endif

namespace collision_hulls {
namespace {

const std::string kService = "service:";
constexpr double kPatience = 10;  // [s]

using Reader = std::function<Scene(const std::string& name, const std::string& root_link, const RunControl& control)>;

/// A type of message that holds a scene.
struct Kind {
  std::string package;
  Reader read;  ///< empty if the package was missing at build time
};

[[noreturn]] void fail(const std::string& what, const std::string& reason) {
  throw Error(ErrorCode::kBadOption, "scene '" + what + "' " + reason);
}

template <class Message>
Scene fromTopic(const std::string& name, const std::string& root_link, const RunControl& control) {
  typename Message::ConstPtr message;
  ros::CallbackQueue queue;  // of its own: the node's threads may all be busy
  ros::NodeHandle node;
  node.setCallbackQueue(&queue);
  const boost::function<void(const typename Message::ConstPtr&)> keep = [&](const typename Message::ConstPtr& it) { message = it; };
  const ros::Subscriber subscriber = node.subscribe<Message>(name, 1, keep);
  const auto has_come = [&] {
    queue.callAvailable();
    return message != nullptr;
  };
  if (!waitFor(has_come, kPatience, control))
    fail(kTopicPrefix + name, "sent no message within 10 s; make its node publish one, or latch it");
  return toScene(*message, root_link, control);
}

std::map<std::string, Kind> topicKinds() {
  std::map<std::string, Kind> kinds{{"moveit_msgs/PlanningScene", {"moveit_msgs", {}}}, {"octomap_msgs/Octomap", {"octomap_msgs", {}}}};
#ifdef COLLISION_HULLS_MOVEIT_MSGS
  kinds["moveit_msgs/PlanningScene"].read = fromTopic<moveit_msgs::PlanningScene>;
#endif
#ifdef COLLISION_HULLS_OCTOMAP_MSGS
  kinds["octomap_msgs/Octomap"].read = fromTopic<octomap_msgs::Octomap>;
#endif
  return kinds;
}

[[noreturn]] void failWithout(const std::string& source, const std::string& package) {
  fail(source, "needs the messages of " + package + ", which was missing when collision_hulls was built; install " + package +
                   ", or put its source into the workspace, and build again. Scenes in files need no other package");
}

Scene readTopic(const std::string& name, const std::string& root_link, const RunControl& control) {
  const std::optional<std::string> type = typeOfTopic(name);
  if (!type) fail(kTopicPrefix + name, "has no publisher; start its node, or give the full name (see 'rostopic list')");
  const std::map<std::string, Kind> kinds = topicKinds();
  const auto kind = kinds.find(*type);
  if (kind == kinds.end()) fail(kTopicPrefix + name, "is a " + *type + "; give a moveit_msgs/PlanningScene or an octomap_msgs/Octomap");
  if (!kind->second.read) failWithout(kTopicPrefix + name, kind->second.package);
  return kind->second.read(name, root_link, control);
}

#ifdef COLLISION_HULLS_MOVEIT_MSGS
Scene readService(const std::string& name, const std::string& root_link, const RunControl& control) {
  moveit_msgs::GetPlanningScene call;
  using Components = moveit_msgs::PlanningSceneComponents;
  call.request.components.components = Components::SCENE_SETTINGS | Components::ROBOT_STATE | Components::WORLD_OBJECT_NAMES |
                                       Components::WORLD_OBJECT_GEOMETRY | Components::OCTOMAP | Components::TRANSFORMS;
  const auto is_there = [&] { return ros::service::exists(name, false); };
  if (!waitFor(is_there, kPatience, control))
    fail(kService + name, "does not exist; start move_group, or give the full name (see 'rosservice list')");
  ros::NodeHandle node;
  ros::ServiceClient client = node.serviceClient<moveit_msgs::GetPlanningScene>(name, true);
  switch (callInTime(client, call, kPatience, control)) {
    case Called::kAnswered: break;
    case Called::kFailed: fail(kService + name, "gave no answer; it must be a moveit_msgs/GetPlanningScene");
    case Called::kLate: fail(kService + name, "did not answer within 10 s; see whether move_group is busy or stopped");
  }
  return toScene(call.response.scene, root_link, control);
}
#else
Scene readService(const std::string& name, const std::string&, const RunControl&) {
  failWithout(kService + name, "moveit_msgs");
}
#endif

bool beginsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

}  // namespace

bool isLive(const std::string& source) {
  return beginsWith(source, kTopicPrefix) || beginsWith(source, kService);
}

Scene liveScene(const std::string& source, const std::string& root_link, const RunControl& control) {
  const bool topic = beginsWith(source, kTopicPrefix);
  const std::string name = source.substr((topic ? kTopicPrefix : kService).size());
  Scene scene = topic ? readTopic(name, root_link, control) : readService(name, root_link, control);
  if (scene.name.empty()) scene.name = name;
  return scene;
}

}  // namespace collision_hulls
