// The output in a consumer's own form: what a planner or simulator needs beside the description and
// the hulls.
//
// For example:
//
//     #include "collision_hulls/pipeline/decompose_robot.h"
//     #include "collision_hulls/pipeline/output.h"
//
//     RobotResult result = decompose(openInput("arm.urdf"), Options(), "arm_collision");
//     addConsumerFiles({Consumer::kMujoco}, "arm_collision", result);
//     writeOutput(result, "arm_collision");
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

enum class Consumer {
  kMoveit,
  kGazebo,
  kMujoco,
  kDrake,
  kIsaac,
  kTesseract,
  kCurobo,
  kDart,
  kBullet  ///< takes the description as it is: no file of its own, but a note in the report
};

const char* name(Consumer consumer);  ///< "moveit", "gazebo", "mujoco", ...
std::optional<Consumer> consumerNamed(const std::string& name);
std::string consumerChoices();  ///< the names of all, for messages

/// The format that suits them all, where nobody asks for one: `usual`, unless one of them cannot
/// read it.
MeshFormat formatFor(const std::vector<Consumer>& consumers, MeshFormat usual);

/// The shapes that suit them all, where nobody asks for some: spheres if one of them takes nothing
/// else, and otherwise `usual`.
Shapes shapesFor(const std::vector<Consumer>& consumers, Shapes usual);

/// Throws kBadOption for a format, shapes, URIs or a model's name that a consumer cannot take; the
/// message says what to choose instead.
void check(const std::vector<Consumer>& consumers, const Options& options);

/// Throws kBadOption for a description for which addConsumerFiles() would throw it whatever becomes
/// of the meshes, so that it can be refused before the long work. Throws kCancelled.
void check(const std::vector<Consumer>& consumers, const Options& options,
           const RobotDescription& robot, const RunControl& control = {});

/// Adds each consumer's files to the result's `extra_files`. `output`: the folder that will be
/// written, whose name is the package's. They describe the first model. `step` is called before the
/// pairs of links that never meet are proved, which takes seconds for a robot of many links. Throws
/// as check(), kBadOption for a single mesh, kCancelled, and the errors of parseRobotDescription()
/// and Kinematics.
void addConsumerFiles(const std::vector<Consumer>& consumers, const std::string& output,
                      RobotResult& result, const RunControl& control = {},
                      const StepCallback& step = {});

/// A line for each consumer, for a terminal: its file in a written output, and how it is loaded.
std::string howToLoad(const std::vector<Consumer>& consumers, const RobotResult& result,
                      const std::string& output);

}  // namespace collision_hulls
