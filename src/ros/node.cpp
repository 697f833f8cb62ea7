// Reads a request and the parameters, runs the library, writes and shows the result. The doors (door.h) bring requests in and answers out.
#include "node.h"

#include <filesystem>
#include <memory>

#include "collision_hulls/pipeline/fit_scene.h"
#include "collision_hulls/pipeline/output.h"
#include "collision_hulls/pipeline/progress_text.h"
#include "conversions.h"
#include "parameters.h"
#include "preview/validation.h"

namespace collision_hulls {
namespace {

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

/// Writes the result. The fields that both responses have.
template <typename Response>
Response written(RobotResult& result, const std::string& output, const std::vector<std::string>& package_path, bool brief,
                 const RunControl& control) {
  Response response;
  response.success = !anyFailed(result.report);
  response.message = summary(result.robot_name, result.report);
  if (writeOutput(result, output, control)) {
    response.message += howToUse(result, output, package_path);
    response.message.pop_back();  // its last line's end
    response.urdf_path = output + "/" + result.report.urdf;
  } else {
    response.message += "; nothing was written";
  }
  if (!brief) {
    response.robot_description = result.urdf;
    response.report = toJson(result.report);
  }
  response.table = inNodeWords(toTable(result.report));
  response.totals = toTotals(result.report);
  response.links = toMessages(result);
  ROS_LOG(response.success && response.totals.degraded == 0 ? ros::console::levels::Info : ros::console::levels::Warn,
          ROSCONSOLE_DEFAULT_NAME, "%s", response.message.c_str());
  return response;
}

/// The log says at once what begins, and every few seconds how far it is.
StepCallback logged(const StepCallback& step) {
  return [step, is_due = std::make_shared<Throttle>()](const Step& now) {
    if ((*is_due)()) ROS_INFO("%s", progressLine(now).c_str());
    if (step) step(now);
  };
}

bool isBlank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

}  // namespace

Node::Node()
    : decompose_door_(private_, "decompose", worker_,
                      [this](const auto& request, const auto& control, const auto& step) { return decompose(request, control, step); }),
      fit_door_(private_, "fit_scene", worker_,
                [this](const auto& request, const auto& control, const auto& step) { return fit(request, control, step); }),
      build_door_(private_, "build", worker_,
                  [this](const auto& request, const auto& control, const auto& step) { return build(request, control, step); }),
      validate_door_(private_, "validate", worker_,
                     [this](const auto& request, const auto& control, const auto& step) { return validate(request, control, step); }) {
  warnOfMistyped(private_);
  if (startsAtOnce()) decomposeAtStart();  // before the doors open, so that no caller is first
  decompose_door_.open();
  fit_door_.open();
  build_door_.open();
  validate_door_.open();
  preview_.open();
}

bool Node::startsAtOnce() const {
  bool at_once = false;
  try {
    readFlag(private_, "auto", at_once);
  } catch (const Error& error) {
    ROS_ERROR("%s", error.what());
  }
  return at_once;
}

void Node::decomposeAtStart() {
  const auto decomposed = [this](const RunControl& control) {
    const auto [name, text] = robotParameter();
    if (isBlank(text.value_or("")))
      throw Error(ErrorCode::kFileNotFound, "no robot description: start with robot:=FILE, or set the parameter " + name);
    return decompose({}, control, {});
  };
  const auto work = [decomposed](const RunControl& control) { answered<DecomposeResponse>([&] { return decomposed(control); }); };
  worker_.start({"the robot description found at start-up", work, [] {}});
}

DecomposeResponse Node::decompose(const DecomposeRequest& request, const RunControl& control, const StepCallback& step) {
  checkTexts(request);
  const Confinement confinement(places_.roots());
  const StatedJob job(preview_, "decompose");
  const Input input = inputOf(request.robot_description, request.base, control);
  const Options options = requestedOptions(configured(private_, request.config, readOptions(private_), control), request, input.robot);
  const LinkDecisions decisions = firstModelDecisions(options, input.robot, control);  // before anything is written: it may take long
  const std::string output = outputFor(request, input, control);

  const ViewedRun view(view_, input.robot, input.find_package, options, control);
  RobotResult result = decomposeRobot(input.robot, input.find_package, options, output, control, job.stated(view.shown(logged(step))));
  DecomposeResponse response = written<DecomposeResponse>(result, output, places_.packagePath(), request.brief, control);
  if (!response.urdf_path.empty()) {
    written_[output] = input.robot.name;
    show(input.robot, decisions, result);
  }
  return response;
}

FitSceneResponse Node::fit(const FitSceneRequest& request, const RunControl& control, const StepCallback& step) {
  checkTexts(request);
  const Confinement confinement(places_.roots());
  const StatedJob job(preview_, "fit_scene");
  const Input input = inputOf(request.robot_description, request.base, control);
  Options own = readOptions(private_);
  own.method = Method::kCertified;  // what a fit refuses is for the other job
  own.tree.reset();
  own.time_limit = 0;
  own.segments = false;
  own.shapes = Shapes::kHulls;
  own.padding = 0;
  const Options options = requestedOptions(configured(private_, request.config, own, control), toRequest(request), input.robot);
  const LinkDecisions decisions = firstModelDecisions(options, input.robot, control);
  const std::string output = outputFor(request, input, control);
  const SceneRequest scene = requestedScene(request, input, options, control);

  const ViewedRun view(view_, input.robot, input.find_package, options, control);
  RobotResult result =
      fitRobotToScene(input.robot, input.find_package, scene, options, output, control, job.stated(view.shown(logged(step))));
  FitSceneResponse response = written<FitSceneResponse>(result, output, places_.packagePath(), request.brief, control);
  if (!response.urdf_path.empty()) {
    written_[output] = input.robot.name;
    show(input.robot, decisions, result, &scene.scene);
  }
  if (!request.brief && !result.extra_files.empty()) response.srdf = result.extra_files.begin()->second;
  return response;
}

/// A build of some links of a known robot shows these alone, and needs no word on its progress: it follows each move of a slider.
BuildResponse Node::build(const BuildRequest& request, const RunControl& control, const StepCallback& step) {
  checkTexts(request);
  const Confinement confinement(places_.roots());
  const StatedJob job(preview_, "build");
  const Input input = inputOf(request.robot_description, "", control);
  const Options options = buildOptions(configured(private_, request.config, readOptions(private_), control), request, input.robot, control);
  std::optional<ViewedRun> view;
  if (request.only.empty() || preview_.isNews(input.robot)) view.emplace(view_, input.robot, input.find_package, options, control);
  const StepCallback stated = job.stated(view ? view->shown(logged(step)) : step);
  const RobotResult result = preview_.trees().build(input.robot, input.find_package, options, control, stated);
  preview_.take(input.robot, LinkDecisions(options, input.robot, control), result);
  BuildResponse response;
  response.success = !anyFailed(result.report);
  response.message = summary(result.robot_name, result.report);
  response.links = preview_.messages(request.only, control);
  preview_.show(request.only, control);
  return response;
}

ValidateResponse Node::validate(const ValidateRequest& request, const RunControl& control, const StepCallback& step) {
  checkTexts(request);
  const Confinement confinement(places_.roots());
  const StatedJob job(preview_, "validate");
  const std::map<std::string, LinkResult> links = preview_.results(request.only);
  const RobotDescription robot = preview_.robot();
  const PackageFinder find_package = places_.packageFinder(robot.path);
  const Validation found = validateLinks(robot, find_package, readOptions(private_), links, control, job.stated(logged(step)));
  ValidateResponse response;
  response.success = found.holds();
  response.message = summary(found);
  response.queries = static_cast<std::uint32_t>(found.queries);
  response.missed = static_cast<std::uint32_t>(found.missed);
  response.phantom = static_cast<std::uint32_t>(found.phantom);
  response.max_underestimate = found.max_underestimate;
  return response;
}

Input Node::inputOf(const std::string& robot_description, const std::string& base, const RunControl& control) const {
  Input input;
  input.robot = readRobot(robot_description, base, control);
  input.find_package = places_.packageFinder(input.robot.path);
  return input;
}

/// Nodes in different namespaces, one for each of several arms, have different default folders. Somebody who sends a robot does not replace
/// the model of another one unawares.
template <typename Request>
std::string Node::outputFor(const Request& request, const Input& input, const RunControl& control) const {
  std::string wanted = request.output.empty() ? textParameter(private_, "output") : request.output;
  if (wanted.empty()) wanted = (std::filesystem::path(NodePlaces::namespaceFolder()) / defaultOutput(input)).string();
  const std::string output = places_.output(wanted);
  const auto earlier = written_.find(output);
  if (request.output.empty() && !request.robot_description.empty() && earlier != written_.end() && earlier->second != input.robot.name)
    throw Error(ErrorCode::kBadOption, "'" + output + "' holds the model of robot '" + earlier->second +
                                           "' that this node wrote; name another folder for robot '" + input.robot.name +
                                           "' in the field `output`");
  checkOutput(output, control);
  return output;
}

/// Its name, and its value if that is a text.
std::pair<std::string, std::optional<std::string>> Node::robotParameter() const {
  std::string name, text;
  if (node_.searchParam("robot_description", name) && node_.getParam(name, text)) return {name, text};
  return {node_.resolveName("robot_description"), std::nullopt};
}

/// ~base belongs to the parameter's text: what a request brings comes from elsewhere, where other meshes may have the same names. A
/// request's own base counts in any case.
RobotDescription Node::readRobot(const std::string& text, const std::string& base, const RunControl& control) const {
  const auto [key, value] = robotParameter();
  const std::string parameter = value.value_or("");
  checkBase(base);
  if (!text.empty() && (!base.empty() || text != parameter)) {
    refusePath("robot_description", text, {".urdf", ".xacro"}, "send the text of the URDF, and the path as `base`");
    return parseRobotDescription(text, base, control);
  }
  if (isBlank(parameter))
    throw Error(ErrorCode::kFileNotFound, "no robot description: the request has none, and the parameter " + key +
                                              (value ? " is empty" : " is not set to a text") + "; give one or the other");
  refusePath("robot_description", parameter, {".urdf", ".xacro"},
             "set the parameter to the text of the URDF, as <param name=\"robot_description\" textfile=\"...\"/> does");
  if (!base.empty()) return parseRobotDescription(parameter, base, control);
  const std::string own = textParameter(private_, "base");
  return parseRobotDescription(parameter, own.empty() ? "" : resolveUri(own, "", places_.packageFinder("")), control);
}

void Node::show(const RobotDescription& robot, const LinkDecisions& decisions, const RobotResult& result, const Scene* scene) try {
  private_.setParam("robot_description", result.urdf);
  view_.show(result, scene);
  preview_.take(robot, decisions, result);
} catch (const std::exception& error) {  // such as the end of memory
  ROS_WARN("the output is written, but cannot be shown: %s", error.what());
}

}  // namespace collision_hulls
