// Robot descriptions from files: .urdf as they are, .xacro through the user's xacro program.
#include <algorithm>
#include <filesystem>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/package_crawl.h"
#include "robot/xacro.h"
#include "storage/text_file.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

/// Whether a file's text names another file, as one does that includes it.
bool mentions(const std::string& file, const std::string& name) try {
  return readTextFile(file, "robot description").find(name) != std::string::npos;
} catch (const Error&) {
  return false;
}

/// The other descriptions of the package that a file lies in, those that include the file first.
std::vector<std::string> descriptionsBeside(const fs::path& file) {
  const std::string package = packageAround(file).string();
  if (package.empty()) return {};
  std::vector<std::string> found = robotDescriptionsIn(package);
  if (found.empty()) found = robotDescriptionsBelow(package).files;
  if (std::find(found.begin(), found.end(), file.string()) != found.end()) return {};  // none of them is more of a robot
  std::stable_partition(found.begin(), found.end(), [&](const std::string& other) { return mentions(other, file.filename().string()); });
  return found;
}

/// What to give in place of a file that expands to no robot.
std::string insteadOf(const std::string& path) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<std::string> found = descriptionsBeside(fs::absolute(path).lexically_normal());
  if (found.empty()) return "often urdf/ROBOT.urdf.xacro";
  const std::size_t more = found.size() - std::min(found.size(), kMostNamed);
  found.resize(found.size() - more);
  return "such as '" + listed(found, "', '") + "'" + (more > 0 ? " or one of " + std::to_string(more) + " more" : "");
}

RobotDescription readXacro(const std::string& path, const std::string& text, const RunControl& control,
                           const std::vector<std::string>& package_path, const std::vector<std::string>& arguments) {
  try {
    RobotDescription robot = parseRobotDescription(expandXacro(path, arguments, package_path, control), path, control);
    robot.xacro_arguments = arguments;
    return robot;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kNoLinks) throw;
    const bool has_macros = text.find("<xacro:macro") != std::string::npos;
    throw Error(ErrorCode::kNoLinks, "'" + path + "' expands to a <robot> without a <link>" +
                                         (has_macros ? ": it defines macros for other files; give one that calls them, "
                                                     : "; give a file that describes a robot, ") +
                                         insteadOf(path));
  }
}

}  // namespace

RobotDescription readRobotDescription(const std::string& path, const RunControl& control, const std::vector<std::string>& package_path,
                                      const std::vector<std::string>& xacro_arguments) {
  // Read in any case: the message about an unreadable file is better than xacro's.
  const std::string text = readTextFile(path, ".urdf or .xacro file", control);
  checkTakesArguments(path, xacro_arguments);
  if (lowerExtension(path) == ".xacro") return readXacro(path, text, control, package_path, xacro_arguments);
  return parseRobotDescription(text, path, control);
}

}  // namespace collision_hulls
