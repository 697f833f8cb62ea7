// Robot descriptions from files: .urdf as they are, .xacro through the user's xacro program.
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/run_program.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "storage/text_file.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

// How much of xacro's own messages is quoted: the end, which has the reason.
constexpr std::size_t kMostQuoted = 2000;

std::string expandXacro(const std::string& path, const RunControl& control) {
  // Absolute, so that no file's name looks like an option.
  const std::optional<ProgramResult> xacro = runProgram({"xacro", fs::absolute(path).string()}, control);
  if (!xacro) {
    throw Error(ErrorCode::kXacroMissing, "'" + path + "' is a xacro file, but there is no program 'xacro' on PATH: install it " +
                                              "(ROS package xacro; or 'pip install xacro') and source your workspace's setup.bash, " +
                                              "or run 'xacro FILE.xacro > FILE.urdf' on a machine that has it, and give the .urdf");
  }
  if (xacro->status == 0) return xacro->out;
  const std::size_t skipped = xacro->errors.size() - std::min(xacro->errors.size(), kMostQuoted);
  throw Error(ErrorCode::kNotARobot,
              "'" + path + "': xacro failed with status " + std::to_string(xacro->status) + ": " + xacro->errors.substr(skipped));
}

std::string expanded(const std::string& path, const RunControl& control) {
  try {
    return expandXacro(path, control);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kTooLarge && error.code() != ErrorCode::kOutOfTime) throw;
    throw Error(error.code(), "'" + path + "': " + error.what());
  } catch (const std::system_error& error) {
    throw Error(ErrorCode::kXacroMissing, "'" + path + "': xacro cannot be run: " + error.what());
  }
}

}  // namespace

RobotDescription readRobotDescription(const std::string& path, const RunControl& control) {
  // Read in any case: the message about an unreadable file is better than xacro's.
  const std::string text = readTextFile(path, ".urdf or .xacro file", control);
  return parseRobotDescription(lowerExtension(path) == ".xacro" ? expanded(path, control) : text, path, control);
}

}  // namespace collision_hulls
