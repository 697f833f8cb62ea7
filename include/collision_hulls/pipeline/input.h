// Finds what to decompose by the name that a user gives: a package, a robot description or a mesh.
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

/// How to open an input.
struct InputOptions {
  std::vector<std::string> package_path = {};     ///< see defaultPackageFinder()
  std::vector<std::string> xacro_arguments = {};  ///< see readRobotDescription()
  /// whether they are left out where the input is not a .xacro file; else they are refused there
  bool may_ignore_arguments = false;
  /// for messages that propose a command: it is this, the input, and the words after it
  std::string program = "decompose";
  std::string words = "";
};

/// `input`: the name or folder of a package, a .urdf or .xacro file, or a mesh file, which is not
/// read yet; a file also by its package:// URI. A package without descriptions in its folders urdf
/// and robots has those of its other folders. Throws kFileNotFound, kPackageNotFound,
/// kUnsupportedFormat; kNotARobot for a package with several descriptions, and the message lists a
/// command for each; and as readRobotDescription() and defaultPackageFinder().
Input openInput(const std::string& input, const InputOptions& options = {},
                const RunControl& control = {});

/// "42 meshes of 17 links": what decompose() will read; empty: no mesh. Of a mesh file, its path in
/// quotes. Throws kBadOption as LinkDecisions, and kCancelled.
std::string workOn(const Input& input, const Options& options, const RunControl& control = {});

/// The default output folder, `./<robot>_collision`; for a mesh, with the stem of its file's name.
std::string defaultOutput(const Input& input);

}  // namespace collision_hulls
