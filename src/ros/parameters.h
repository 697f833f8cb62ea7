// Options of a run from the node's private parameters and a request.
#pragma once

#include <collision_hulls/BuildRequest.h>
#include <collision_hulls/DecomposeRequest.h>
#include <collision_hulls/FitSceneRequest.h>
#include <collision_hulls/ValidateRequest.h>
#include <ros/node_handle.h>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// Options as the parameters ~profile, ~tolerance ("1cm,5%", "1%", "5mm" or a number of metres), ~method, ~effort, ~fill, ~padding,
/// ~close_openings, ~shapes, ~tree, ~max_hulls, ~max_vertices, ~links (regular expression), ~source, ~format, ~uri, ~rebase, ~package_name,
/// ~segments, ~html, ~jobs, ~reader_memory, ~reader_time, ~time_limit, ~validate, ~cache and ~seed say; those that are not set keep their
/// defaults. Throws kBadOption for a value of the wrong type or range.
Options readOptions(const ros::NodeHandle& node);

/// `options` with what a configuration says in their place: `config`, the text in a request, or if that is empty the text of ~config.
/// Throws as parseConfig().
Options configured(const ros::NodeHandle& node, const std::string& config, Options options, const RunControl& control);

/// A list, or a text with colons between its items, such as ~package_path. Throws kBadOption for anything else.
std::vector<std::string> readFolders(const ros::NodeHandle& node, const std::string& name);

/// What is wrong with a name in a request that no link has, and which names there are.
std::string noSuchLink(const RobotDescription& robot, const std::string& name);

/// A text parameter; `fallback` if it is not set. Throws kBadOption if it is not a text.
std::string textParameter(const ros::NodeHandle& node, const std::string& name, const std::string& fallback = "");

/// Sets `value` to a parameter; leaves it if that is not set. Throws kBadOption if it is neither true nor false.
void readFlag(const ros::NodeHandle& node, const std::string& name, bool& value);

/// A number; `fallback` if the parameter is not set. Throws kBadOption if it is not a number.
double numberParameter(const ros::NodeHandle& node, const std::string& name, double fallback);

/// Logs a warning for each parameter in the node's name space that it does not read and whose name is nearly that of one which it reads.
void warnOfMistyped(const ros::NodeHandle& node);

/// Throws kBadOption for a text of a request that is longer than a path can be, or holds control characters: messages quote it.
void checkTexts(const DecomposeRequest& request);
void checkTexts(const FitSceneRequest& request);
void checkTexts(const BuildRequest& request);
void checkTexts(const ValidateRequest& request);

/// Throws kBadOption for a field with a text that is the path of a file, with one of these extensions or from the root, which as XML would
/// be refused without a hint at the mistake. `remedy`: what to do instead.
void refusePath(const std::string& field, const std::string& text, const std::vector<std::string>& extensions, const std::string& remedy);

/// `options` with the request's own in their place. Throws kBadOption, also for a link that the robot does not have.
Options requestedOptions(Options options, const DecomposeRequest& request, const RobotDescription& robot);

/// Options with a tree, for the first model, of the links that the request chooses. Throws as requestedOptions(), and kCancelled.
Options buildOptions(const Options& options, const BuildRequest& request, const RobotDescription& robot, const RunControl& control);

/// The scene and the configurations that a request names, read from files or from what is published now (live_scene.h, joint_states.h).
/// Throws kBadOption, kCancelled, and the readers' errors.
SceneRequest requestedScene(const FitSceneRequest& request, const Input& input, const Options& options, const RunControl& control);

}  // namespace collision_hulls
