// Reads the node's parameters, with the types that YAML gave them, and puts a request's fields in their place.
#include "parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

#include "base/nearest_name.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/config/config.h"
#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/error.h"
#include "config/link_rule.h"
#include "joint_states.h"
#include "live_scene.h"
#include "preview/robot_trees.h"
#include "robot_bounds.h"

namespace collision_hulls {
namespace {

/// All that the node reads; a parameter without effect is perhaps one of these, mistyped.
const std::vector<std::string>& parameterNames() {
  static const std::vector<std::string> names{
      "auto",         "base",         "cache",      "close_openings", "config",        "effort",      "fill",    "format",      "html",
      "jobs",         "links",        "max_hulls",  "max_vertices",   "method",        "opacity",     "output",  "output_root", "padding",
      "package_name", "package_path", "profile",    "read_roots",     "reader_memory", "reader_time", "rebase",  "seed",        "segments",
      "shapes",       "source",       "time_limit", "tolerance",      "tree",          "uri",         "validate"};
  return names;
}

/// "'many', ": a value as a message quotes it; nothing for a list and the like.
std::string quotedValue(const ros::NodeHandle& node, const std::string& name) {
  using XmlRpc::XmlRpcValue;
  XmlRpcValue value;
  node.getParam(name, value);
  const std::set<XmlRpcValue::Type> simple{XmlRpcValue::TypeBoolean, XmlRpcValue::TypeInt, XmlRpcValue::TypeDouble,
                                           XmlRpcValue::TypeString};
  if (simple.count(value.getType()) == 0) return "";
  std::ostringstream text;
  value.write(text);
  return "'" + shown(text.str()) + "', ";
}

[[noreturn]] void throwWrongType(const ros::NodeHandle& node, const std::string& name, const char* type) {
  throw Error(ErrorCode::kBadOption,
              "parameter " + node.resolveName(name) + " is " + quotedValue(node, name) + "not " + type + ": set it to one");
}

/// A parameter's value, or nothing if it is not set. getParam alone reports a value of the wrong type as not set.
template <typename T>
std::optional<T> read(const ros::NodeHandle& node, const std::string& name, const char* type) {
  if (!node.hasParam(name)) return std::nullopt;
  T value{};
  if (!node.getParam(name, value)) throwWrongType(node, name, type);
  return value;
}

/// Read as double, because getParam would round to an int.
void readNumber(const ros::NodeHandle& node, const std::string& name, int& value) {
  constexpr const char* kType = "a whole number";
  const std::optional<double> number = read<double>(node, name, kType);
  if (!number) return;
  if (*number != std::trunc(*number) || std::abs(*number) > std::numeric_limits<int>::max()) throwWrongType(node, name, kType);
  value = static_cast<int>(*number);
}

/// The enumerator that a text parameter or field names.
template <typename T>
T named(std::optional<T> (*parse)(const std::string&), const std::string& option, const std::string& value, const std::string& choices) {
  const std::optional<T> result = parse(value);
  if (!result) throw Error(ErrorCode::kBadOption, option + " '" + value + "' is unknown: use one of " + choices);
  return *result;
}

template <typename T>
void readNamed(const ros::NodeHandle& node, const std::string& name, std::optional<T> (*parse)(const std::string&),
               const std::string& choices, T& value) {
  const std::string text = textParameter(node, name);
  if (!text.empty()) value = named(parse, "parameter " + node.resolveName(name), text, choices);
}

/// Nothing where the parameter is not set or empty. YAML reads "1%" as a text, 0.005 as a number and 1 as a whole one.
std::optional<Length> readLength(const ros::NodeHandle& node, const std::string& name) {
  double metres = 0;
  if (node.getParam(name, metres)) return lengthOf(metres);
  const std::string text = textParameter(node, name);
  if (text.empty()) return std::nullopt;
  return parseTolerance(text, "parameter " + node.resolveName(name));
}

/// A number in SI units, or a text with a unit; 0 where the parameter is not set or empty.
double readQuantity(const ros::NodeHandle& node, const std::string& name, double (*parse)(const std::string&, const std::string&)) {
  double value = 0;
  if (node.getParam(name, value)) return value;
  const std::string text = textParameter(node, name);
  return text.empty() ? 0 : parse(text, "parameter " + node.resolveName(name));
}

/// The regular expression that matches these names alone; empty for all.
std::string linksExpression(const std::string& field, const std::vector<std::string>& names, const RobotDescription& robot) {
  std::set<std::string> known;
  for (const LinkDescription& link : robot.links) known.insert(link.name);
  const std::set<std::string> wanted(names.begin(), names.end());
  for (const std::string& name : wanted) {
    if (known.count(name)) continue;
    throw Error(ErrorCode::kBadOption, field + ": " + noSuchLink(robot, name));
  }
  return wanted == known ? "" : expressionFor({wanted.begin(), wanted.end()});
}

void checkText(const std::string& field, const std::string& text) {
  try {
    checkCharacters(text);
  } catch (const Error& error) {
    throw Error(ErrorCode::kBadOption, field + ": " + error.what());
  }
}

}  // namespace

std::string noSuchLink(const RobotDescription& robot, const std::string& name) {
  std::string list;
  for (const LinkDescription& link : robot.links) list += (list.empty() ? "" : ", ") + link.name;
  const bool is_expression = name.find_first_of("*+?|^$()[]{}\\") != std::string::npos;
  return "robot '" + robot.name + "' has no link '" + name +
         "': " + (is_expression ? "this field takes whole names, and no expressions as ~links does; " : "") + "use some of " + list;
}

std::string textParameter(const ros::NodeHandle& node, const std::string& name, const std::string& fallback) {
  return read<std::string>(node, name, "a text").value_or(fallback);
}

void readFlag(const ros::NodeHandle& node, const std::string& name, bool& value) {
  value = read<bool>(node, name, "true or false").value_or(value);
}

double numberParameter(const ros::NodeHandle& node, const std::string& name, double fallback) {
  return read<double>(node, name, "a number").value_or(fallback);
}

void warnOfMistyped(const ros::NodeHandle& node) {
  std::vector<std::string> names;
  node.getParamNames(names);
  const std::string place = node.getNamespace() + "/";
  for (const std::string& name : names) {
    if (name.compare(0, place.size(), place) != 0) continue;
    const std::string own = name.substr(place.size());
    const std::vector<std::string>& known = parameterNames();
    if (std::find(known.begin(), known.end(), own) != known.end()) continue;
    const std::string hint = didYouMean(own, known);
    if (!hint.empty()) ROS_WARN("parameter %s has no effect%s", name.c_str(), hint.c_str());
  }
}

Options readOptions(const ros::NodeHandle& node) {
  Options options;
  const std::string profile = textParameter(node, "profile");
  if (!profile.empty()) applyProfile(profile, options);
  options.tolerance = readLength(node, "tolerance").value_or(options.tolerance);
  readNamed(node, "method", methodNamed, methodChoices(), options.method);
  readNamed(node, "effort", effortNamed, effortChoices(), options.effort);
  readFlag(node, "fill", options.fill);
  options.padding = readQuantity(node, "padding", parsePadding);
  options.close_openings = readQuantity(node, "close_openings", parsePadding);
  readNamed(node, "shapes", shapesNamed, shapesChoices(), options.shapes);
  readFlag(node, "segments", options.segments);
  options.tree = readLength(node, "tree");
  if (options.tree && options.tree->limit == 0) options.tree.reset();
  readNumber(node, "max_hulls", options.max_hulls);
  readNumber(node, "max_vertices", options.max_vertices);
  options.links = textParameter(node, "links");
  readNamed(node, "source", sourceNamed, "auto, visual, collision", options.source);
  readNamed(node, "format", meshFormatNamed, "stl, obj, dae", options.format);
  readNamed(node, "uri", uriStyleNamed, "package, file, relative", options.uri);
  readFlag(node, "rebase", options.rebase);
  options.package_name = textParameter(node, "package_name");
  readNumber(node, "jobs", options.jobs);
  readNumber(node, "reader_memory", options.reader_memory);
  readNumber(node, "reader_time", options.reader_time);
  options.time_limit = readQuantity(node, "time_limit", parseSeconds);
  readFlag(node, "validate", options.validate);
  readFlag(node, "cache", options.cache);
  readFlag(node, "html", options.html);
  int seed = static_cast<int>(options.seed);
  readNumber(node, "seed", seed);
  if (seed < 0) throw Error(ErrorCode::kBadOption, "parameter " + node.resolveName("seed") + " is negative: use a number from 0");
  options.seed = static_cast<std::uint64_t>(seed);
  check(options);
  return options;
}

Options configured(const ros::NodeHandle& node, const std::string& config, Options options, const RunControl& control) {
  const std::string text = config.empty() ? textParameter(node, "config") : config;
  if (!text.empty()) apply(parseConfig(text, config.empty() ? node.resolveName("config") : "config", control), options);
  return options;
}

std::vector<std::string> readFolders(const ros::NodeHandle& node, const std::string& name) {
  std::vector<std::string> folders;
  if (node.getParam(name, folders)) return folders;
  std::istringstream list(read<std::string>(node, name, "a text or a list of texts").value_or(""));
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.push_back(folder);
  }
  return folders;
}

void checkTexts(const DecomposeRequest& request) {
  checkText("base", request.base);
  checkText("output", request.output);
  checkText("method", request.method);
  for (const std::string& link : request.links) checkText("links", link);
}

void checkTexts(const FitSceneRequest& request) {
  checkText("base", request.base);
  checkText("output", request.output);
  checkText("scene", request.scene);
  checkText("configurations", request.configurations);
  checkText("joints", request.joints);
  for (const std::string& joint : request.at) checkText("at", joint);
  for (const std::string& link : request.links) checkText("links", link);
}

void checkTexts(const BuildRequest& request) {
  for (const std::string& link : request.only) checkText("only", link);
}

void checkTexts(const ValidateRequest& request) {
  for (const std::string& link : request.only) checkText("only", link);
}

void refusePath(const std::string& field, const std::string& text, const std::vector<std::string>& extensions, const std::string& remedy) {
  const std::string line = trimmed(text, " \t\r\n"), extension = lowerExtension(line);
  const bool ends_so = std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
  if (!line.empty() && (line.front() == '/' || ends_so) && line.find('\n') == std::string::npos)
    throw Error(ErrorCode::kBadOption, field + " is the path '" + shown(line) + "': " + remedy);
}

Options requestedOptions(Options options, const DecomposeRequest& request, const RobotDescription& robot) {
  const auto unsetIfZero = [](double part) { return part == 0 ? Length::kUnset : part; };
  if (request.tolerance != 0 || request.relative_tolerance != 0)
    options.tolerance = {unsetIfZero(request.tolerance), unsetIfZero(request.relative_tolerance)};
  if (request.max_hulls != 0) options.max_hulls = request.max_hulls;
  if (request.max_vertices != 0) options.max_vertices = request.max_vertices;
  if (request.time_limit != 0) options.time_limit = request.time_limit;
  if (!request.method.empty()) options.method = named(methodNamed, "method", request.method, methodChoices());
  if (!request.links.empty()) {
    options.links = linksExpression("links", request.links, robot);
    options.links_place.clear();
  }
  check(options);
  return options;
}

Options buildOptions(const Options& options, const BuildRequest& request, const RobotDescription& robot, const RunControl& control) {
  const LinkDecisions decisions = firstModelDecisions(options, robot, control);
  Options result = options;
  result.rules.clear();
  for (const LinkDescription& link : robot.links)
    if (const LinkOptions* const own = decisions.of(link.name)) result.rules.push_back(ruleFor(link.name, *own));
  result.method = Method::kCertified;  // of links without a rule: there are none
  result.segments = false;
  result.models.clear();
  if (!result.tree) result.tree = previewTree(options.tolerance);
  result.time_limit = 0;  // trees are built whole
  if (!request.only.empty()) {
    result.links = linksExpression("only", request.only, robot);
    result.links_place.clear();
  }
  check(result);
  return result;
}

SceneRequest requestedScene(const FitSceneRequest& request, const Input& input, const Options& options, const RunControl& control) {
  if (request.scene.empty()) throw Error(ErrorCode::kBadOption, "scene is empty: give the file of a scene, or topic:NAME");
  if (request.samples < 0)
    throw Error(ErrorCode::kBadOption, "samples is " + std::to_string(request.samples) + ": give a number from 1, or 0 for the default");
  FitOptions fit;
  fit.clearance = request.clearance;
  check(fit);  // before anything that takes long
  const std::map<std::string, double> at = jointPositions(request.at, "at");
  refusePath("srdf", request.srdf, {".srdf", ".xacro"}, "send the text of the file");
  const auto file = [&](const std::string& uri) { return uri.empty() ? "" : resolveUri(uri, input.robot.path, input.find_package); };
  const bool live = isLive(request.scene), joint_states = areJointStates(request.configurations);
  SceneSources sources;
  sources.mesh_limits = meshLimits(options);
  try {
    if (!live) sources.scene = file(request.scene);
  } catch (const Error& e) {
    throw Error(e.code(), std::string("scene: ") + e.what());
  }
  sources.srdf = request.srdf;
  if (!joint_states) sources.configurations = file(request.configurations), sources.max_step = request.max_step;
  SceneRequest scene = readSceneRequest(input, sources, control);
  if (live) scene.scene = liveScene(request.scene, rootLink(input.robot), control);
  if (joint_states)
    giveConfigurations(
        readJointStates(request.configurations, file, Kinematics(input.robot), givenConfigurations(request.max_step), control), scene);
  scene.clearance = request.clearance;
  scene.primitives = !request.hulls_only;
  scene.joints = request.joints;
  scene.at = at;
  if (request.samples > 0) scene.samples = static_cast<std::size_t>(request.samples);
  return scene;
}

}  // namespace collision_hulls
