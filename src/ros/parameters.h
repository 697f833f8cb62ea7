// From the node's private parameters and a request to the options of a run.
#pragma once

#include <collision_hulls/DecomposeRequest.h>
#include <collision_hulls/FitSceneRequest.h>
#include <ros/node_handle.h>

#include "collision_hulls/pipeline/fit_scene.h"
#include "collision_hulls/pipeline/options.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// Options as the parameters ~profile, ~tolerance ("1cm,5%", "1%", "5mm" or a number of metres), ~method, ~effort, ~fill, ~tree,
/// ~max_hulls, ~max_vertices, ~links (regular expression), ~source, ~format, ~uri, ~package_name, ~jobs, ~validate, ~cache and ~seed say;
/// those that are not set keep their defaults. Throws kBadOption for a value of the wrong type or range.
Options readOptions(const ros::NodeHandle& node);

/// ~package_path, a list or a text with colons between its items: where packages lie that ROS does not find, see defaultPackageFinder().
std::vector<std::string> readPackagePath(const ros::NodeHandle& node);

/// A text parameter; `fallback` where it is not set. Throws kBadOption where it is not a text.
std::string readText(const ros::NodeHandle& node, const std::string& name, const std::string& fallback = "");

/// The value of a parameter; as it is where that is not set. Throws kBadOption where it is neither true nor false.
void readFlag(const ros::NodeHandle& node, const std::string& name, bool& value);

/// `options` with what the request asks for. Throws kBadOption, also for the name of a link that the robot does not have.
Options requestedOptions(Options options, const DecomposeRequest& request, const RobotDescription& robot);

/// What the request asks to be fitted to: its files read, or what is published now; see live_scene.h and joint_states.h. Throws kBadOption,
/// kCancelled, and the readers' errors.
SceneRequest requestedScene(const FitSceneRequest& request, const Input& input, const RunControl& control);

}  // namespace collision_hulls
