// The node: the service, the action and the topic over one worker.
#pragma once

#include <actionlib/server/action_server.h>
#include <collision_hulls/Decompose.h>
#include <collision_hulls/DecomposeAction.h>
#include <collision_hulls/FitScene.h>
#include <ros/ros.h>

#include <functional>
#include <string>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "worker.h"

namespace collision_hulls {

/// Serves ~decompose, ~decompose_action and ~fit_scene, publishes ~markers and sets ~robot_description. One request is worked on at a time,
/// on a thread of its own; another one that arrives meanwhile is refused at once. A request that cannot be met gets the library's message;
/// the node lives on. Needs a spinner with at least two threads: a service call keeps one until it is answered.
class Node {
 public:
  Node();

  /// Cancels what is being worked on and refuses further requests; for the way out.
  void stop() { worker_.stop(); }

 private:
  using ActionServer = actionlib::ActionServer<DecomposeAction>;
  using GoalHandle = ActionServer::GoalHandle;

  bool serve(DecomposeRequest& request, DecomposeResponse& response);
  bool serveFit(FitSceneRequest& request, FitSceneResponse& response);
  /// Waits for `work` on the worker's thread; the message says so where it is busy.
  void serveOne(const std::function<void(const RunControl&)>& work, std::string& message);
  void pursue(GoalHandle goal);
  bool isToStartAtOnce() const;
  void decomposeAtStart();
  std::string busy() const;

  /// The whole jobs. Throw what is wrong.
  DecomposeResponse decompose(const DecomposeRequest& request, const RunControl& control, const StepCallback& step) const;
  FitSceneResponse fit(const FitSceneRequest& request, const RunControl& control) const;
  std::string outputFor(const std::string& requested, const Input& input) const;
  RobotDescription readRobot(const std::string& text, const std::string& base) const;
  void show(const RobotResult& result) const;

  ros::NodeHandle node_, private_{"~"};
  ros::Publisher markers_;
  ActionServer action_;
  ros::ServiceServer service_, fit_service_;
  Worker worker_;  // after what its jobs use, so that it ends before
};

}  // namespace collision_hulls
