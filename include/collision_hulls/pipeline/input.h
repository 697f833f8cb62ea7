// What the command line's INPUT refers to: a package, a robot description or a mesh.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

struct Input {
  enum class Kind { kRobot, kMesh } kind = Kind::kRobot;
  std::string path;  ///< mesh file
  RobotDescription robot;
  PackageFinder find_package;
};

/// What goes with an INPUT.
struct InputOptions {
  std::vector<std::string> package_path = {};     ///< see defaultPackageFinder()
  std::vector<std::string> xacro_arguments = {};  ///< see readRobotDescription()
  /// whether they are left out where INPUT is not a .xacro file; else they are refused there
  bool may_ignore_arguments = false;
  /// a command is this, the INPUT, and the words after it, as messages propose it
  std::string program = "decompose";
  std::string words = "";
};

/// INPUT: a package name, a .urdf or .xacro file, or a mesh file. A package without descriptions in
/// its folders urdf and robots has those of its other folders. Throws the readers' errors; for
/// several descriptions the message lists a command for each.
Input openInput(const std::string& input, const InputOptions& options = {},
                const RunControl& control = {});

/// "42 meshes of 17 links": what decompose() will read; empty: no mesh. Throws kBadOption as
/// LinkDecisions, and kCancelled.
std::string workOn(const Input& input, const Options& options, const RunControl& control = {});

/// Default output folder: `./<robot>_collision`
std::string defaultOutput(const Input& input);

}  // namespace collision_hulls
