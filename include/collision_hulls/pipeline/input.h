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

/// INPUT: a package name, a .urdf or .xacro file, or a mesh file. `package_path`: see
/// defaultPackageFinder(). A package without descriptions in its folders urdf and robots has those
/// of its other folders. Throws the readers' errors; for several descriptions the message lists a
/// command for each: `program`, the file, `options`.
Input openInput(const std::string& input, const std::vector<std::string>& package_path = {},
                const std::string& program = "decompose", const RunControl& control = {},
                const std::string& options = "");

/// "42 meshes of 17 links": what decompose() will read; empty: no mesh. Throws kBadOption as
/// LinkDecisions, and kCancelled.
std::string workOn(const Input& input, const Options& options, const RunControl& control = {});

/// Default output folder: `./<robot>_collision`
std::string defaultOutput(const Input& input);

}  // namespace collision_hulls
