#include "node.h"

#include <ros/package.h>

#include <filesystem>
#include <future>
#include <memory>
#include <utility>

#include "collision_hulls/pipeline/fit_scene.h"
#include "conversions.h"
#include "parameters.h"

namespace collision_hulls {
namespace {

const char* const kServiceCall = "a service call";
const char* const kStartUp = "the robot description found at start-up";

/// Asks ROS, then the places that are known without it.
PackageFinder packageFinder(const std::string& near) {
  return [fallback = defaultPackageFinder(near)](const std::string& package) -> std::optional<std::string> {
    const std::string folder = ros::package::getPath(package);
    return folder.empty() ? fallback(package) : folder;
  };
}

/// The fields that the goal has in common with the service's request: all of them.
DecomposeRequest toRequest(const DecomposeGoal& goal) {
  DecomposeRequest request;
  request.robot_description = goal.robot_description;
  request.output = goal.output;
  request.links = goal.links;
  request.tolerance = goal.tolerance;
  request.relative_tolerance = goal.relative_tolerance;
  request.max_hulls = goal.max_hulls;
  request.max_vertices = goal.max_vertices;
  request.method = goal.method;
  return request;
}

/// The fields that both requests have.
DecomposeRequest toRequest(const FitSceneRequest& fit) {
  DecomposeRequest request;
  request.links = fit.links;
  request.tolerance = fit.tolerance;
  request.relative_tolerance = fit.relative_tolerance;
  request.max_hulls = fit.max_hulls;
  request.max_vertices = fit.max_vertices;
  return request;
}

/// What a job comes to, or why it failed.
template <typename Response>
Response answer(const std::function<Response()>& job) {
  try {
    return job();
  } catch (const std::exception& error) {
    ROS_ERROR("%s", error.what());
    Response response;
    response.message = error.what();
    return response;
  }
}

/// Writes the result. The fields that both responses have.
template <typename Response>
Response written(RobotResult& result, const std::string& output, const RunControl& control) {
  Response response;
  response.success = !anyFailed(result.report);
  response.robot_description = result.urdf;
  response.message = summary(result.report);
  if (!writeOutput(result, output, control)) {
    response.message += "\nno mesh could be decomposed; nothing is written";
  } else {
    response.message += "\nwritten to " + output;
    response.urdf_path = std::filesystem::directory_iterator(output + "/urdf")->path().string();  // the only file there
  }
  response.report = toJson(result.report);
  response.links = toMessages(result.report);
  ROS_INFO("%s", response.message.c_str());
  return response;
}

DecomposeResult toResult(const DecomposeResponse& response) {
  DecomposeResult result;
  result.success = response.success;
  result.message = response.message;
  result.robot_description = response.robot_description;
  result.urdf_path = response.urdf_path;
  result.report = response.report;
  result.links = response.links;
  return result;
}

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace

Node::Node()
    : markers_(private_.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
      action_(
          private_, "decompose_action", [this](GoalHandle goal) { pursue(std::move(goal)); },
          [this](const GoalHandle& goal) { worker_.cancel(goal.getGoalID().id); }, false) {
  // First, so that it is not told "busy" because of an earlier caller.
  if (isToStartAtOnce()) decomposeAtStart();
  action_.start();
  service_ = private_.advertiseService("decompose", &Node::serve, this);
  fit_service_ = private_.advertiseService("fit_scene", &Node::serveFit, this);
}

bool Node::isToStartAtOnce() const {
  bool at_once = false;
  try {
    readFlag(private_, "auto", at_once);
  } catch (const Error& error) {
    ROS_ERROR("%s", error.what());
  }
  return at_once;
}

std::string Node::busy() const {
  const std::string job = worker_.current();
  return "busy: working on " + (job.empty() ? "another request" : job) + ", try again when it is done";
}

void Node::serveOne(const std::function<void(const RunControl&)>& work, std::string& message) {
  const auto answered = std::make_shared<std::promise<void>>();  // shared, as this call may return before set_value() does
  if (worker_.start({kServiceCall, work, [answered] { answered->set_value(); }})) {
    answered->get_future().wait();
  } else {
    message = busy();
  }
}

bool Node::serve(DecomposeRequest& request, DecomposeResponse& response) {
  serveOne([&](const RunControl& control) { response = answer<DecomposeResponse>([&] { return decompose(request, control, {}); }); },
           response.message);
  return true;
}

bool Node::serveFit(FitSceneRequest& request, FitSceneResponse& response) {
  serveOne([&](const RunControl& control) { response = answer<FitSceneResponse>([&] { return fit(request, control); }); },
           response.message);
  return true;
}

void Node::pursue(GoalHandle goal) {
  const auto response = std::make_shared<DecomposeResponse>();
  const auto cancelled = std::make_shared<bool>(false);
  const auto work = [=](const RunControl& control) mutable {
    goal.setAccepted();
    if (goal.getGoalStatus().status == actionlib_msgs::GoalStatus::PREEMPTING) control.cancel();  // it came before the job began
    const auto feedback = [&](const Step& step) { goal.publishFeedback(toMessage(step)); };
    *response = answer<DecomposeResponse>([&] { return decompose(toRequest(*goal.getGoal()), control, feedback); });
    *cancelled = control.cancelled() && response->urdf_path.empty();
  };
  const auto reply = [=]() mutable {
    if (*cancelled) {
      goal.setCanceled(toResult(*response), response->message);
    } else if (response->success) {
      goal.setSucceeded(toResult(*response), response->message);
    } else {
      goal.setAborted(toResult(*response), response->message);
    }
  };
  if (worker_.start({goal.getGoalID().id, work, reply})) return;
  response->message = busy();
  goal.setRejected(toResult(*response), response->message);
}

void Node::decomposeAtStart() {
  const auto work = [this](const RunControl& control) { answer<DecomposeResponse>([&] { return decompose({}, control, {}); }); };
  worker_.start({kStartUp, work, [] {}});
}

DecomposeResponse Node::decompose(const DecomposeRequest& request, const RunControl& control, const StepCallback& step) const {
  const std::string base = readText(private_, "base");
  const RobotDescription robot = readRobot(request.robot_description, base);
  const Options options = requestedOptions(readOptions(private_), request, robot);
  const Input input{Input::Kind::kRobot, "", robot, packageFinder(robot.path)};
  const std::string output = outputFor(request.output, input);

  RobotResult result = decomposeRobot(robot, input.find_package, options, output, control, step);
  DecomposeResponse response = written<DecomposeResponse>(result, output, control);
  if (!response.urdf_path.empty()) show(result);
  return response;
}

FitSceneResponse Node::fit(const FitSceneRequest& request, const RunControl& control) const {
  const RobotDescription robot = readRobot(request.robot_description, readText(private_, "base"));
  Options own = readOptions(private_);
  own.method = Method::kCertified;  // whatever other requests are answered by
  own.tree.reset();
  const Options options = requestedOptions(own, toRequest(request), robot);
  const Input input{Input::Kind::kRobot, "", robot, packageFinder(robot.path)};
  const std::string output = outputFor(request.output, input);
  const SceneRequest scene = requestedScene(request, input, control);

  RobotResult result = fitRobotToScene(robot, input.find_package, scene, options, output, control);
  FitSceneResponse response = written<FitSceneResponse>(result, output, control);
  if (!response.urdf_path.empty()) show(result);
  if (!result.extra_files.empty()) response.srdf = result.extra_files.begin()->second;
  return response;
}

std::string Node::outputFor(const std::string& requested, const Input& input) const {
  const std::string wanted = requested.empty() ? readText(private_, "output") : requested;
  const std::string output = absolute(wanted.empty() ? defaultOutput(input) : wanted);
  checkOutput(output);
  return output;
}

RobotDescription Node::readRobot(const std::string& text, const std::string& base) const {
  const std::string path = base.empty() ? "" : resolveUri(base, "", packageFinder(""));
  if (!text.empty()) return parseRobotDescription(text, path);
  std::string key, parameter;
  if (!node_.searchParam("robot_description", key) || !node_.getParam(key, parameter)) {
    throw Error(ErrorCode::kFileNotFound, "no robot description: the request has none and the parameter " +
                                              node_.resolveName("robot_description") + " is not set to a text; give either");
  }
  return parseRobotDescription(parameter, path);
}

void Node::show(const RobotResult& result) const {
  markers_.publish(toMarkers(result));
  private_.setParam("robot_description", result.urdf);
}

}  // namespace collision_hulls
