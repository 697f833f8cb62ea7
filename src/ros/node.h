// The node: four kinds of job, each with a service and an action, over one worker.
#pragma once

#include <collision_hulls/Build.h>
#include <collision_hulls/BuildAction.h>
#include <collision_hulls/Decompose.h>
#include <collision_hulls/DecomposeAction.h>
#include <collision_hulls/FitScene.h>
#include <collision_hulls/FitSceneAction.h>
#include <collision_hulls/Validate.h>
#include <collision_hulls/ValidateAction.h>
#include <ros/ros.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "door.h"
#include "places.h"
#include "preview/link_previews.h"
#include "view.h"
#include "worker.h"

namespace collision_hulls {

/// Serves ~decompose, ~fit_scene, ~build and ~validate, each also as an action, and ~preview; publishes the topics of view.h and ~state,
/// and sets ~robot_description. It works on one request at a time, on a thread of its own, and refuses another that arrives meanwhile. A
/// request that it cannot meet gets the library's message; the node lives on. Needs a spinner with at least two threads: a service call
/// occupies one until it is answered.
class Node {
 public:
  /// Throws kBadOption for a parameter of places.h that has the wrong type.
  Node();

  /// For the way out: cancels the running job and previews, and refuses further requests.
  void stop() {
    worker_.stop();
    preview_.stop();
  }

  /// Whether no job runs.
  bool idle() const { return worker_.current().empty(); }

 private:
  bool startsAtOnce() const;
  void decomposeAtStart();

  /// The jobs. Throw what is wrong.
  DecomposeResponse decompose(const DecomposeRequest& request, const RunControl& control, const StepCallback& step);
  FitSceneResponse fit(const FitSceneRequest& request, const RunControl& control, const StepCallback& step);
  BuildResponse build(const BuildRequest& request, const RunControl& control, const StepCallback& step);
  ValidateResponse validate(const ValidateRequest& request, const RunControl& control, const StepCallback& step);
  Input inputOf(const std::string& robot_description, const std::string& base, const RunControl& control) const;
  template <typename Request>
  std::string outputFor(const Request& request, const Input& input, const RunControl& control) const;
  std::pair<std::string, std::optional<std::string>> robotParameter() const;
  RobotDescription readRobot(const std::string& text, const std::string& base, const RunControl& control) const;
  void show(const RobotDescription& robot, const LinkDecisions& decisions, const RobotResult& result, const Scene* scene = nullptr);

  ros::NodeHandle node_, private_{"~"};
  const NodePlaces places_{private_};
  std::map<std::string, std::string> written_;  // robots by the folder of their model; for the worker alone
  View view_{private_};
  LinkPreviews preview_{private_, view_};
  Door<Decompose, DecomposeAction> decompose_door_;
  Door<FitScene, FitSceneAction> fit_door_;
  Door<Build, BuildAction> build_door_;
  Door<Validate, ValidateAction> validate_door_;
  Worker worker_;  // last, so that its thread ends before what its jobs use
};

}  // namespace collision_hulls
