// Robot descriptions from files: .urdf as they are, .xacro through the user's xacro program.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/run_program.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

// Far beyond any description; keeps an endless file (a device) from filling the memory.
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

// How much of xacro's own messages stands in ours: the end, where its reason is.
constexpr std::size_t kMostQuoted = 2000;

void checkReadable(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw Error(ErrorCode::kFileNotFound, "'" + path + "': no such file; give the path of a .urdf or .xacro file");
  if (fs::is_directory(status)) throw Error(ErrorCode::kFileNotFound, "'" + path + "' is a folder; give the .urdf or .xacro file in it");
}

std::string readText(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorCode::kFileNotFound, "'" + path + "' cannot be read: " + std::strerror(errno));
  std::string text;
  char buffer[65536];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (text.size() > kMostBytes) {
      throw Error(ErrorCode::kTooLarge, "'" + path + "' has more than " + std::to_string(kMostBytes) + " bytes; no robot description has");
    }
  }
  return text;
}

bool isXacro(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".xacro";
}

std::string expandXacro(const std::string& path) {
  // Absolute, so that no file's name looks like an option.
  const std::optional<ProgramResult> xacro = runProgram({"xacro", fs::absolute(path).string()});
  if (!xacro) {
    throw Error(ErrorCode::kXacroMissing, "'" + path + "' is a xacro file and no program 'xacro' is on PATH: install it " +
                                              "(ROS package xacro; or 'pip install xacro') and source your workspace's setup.bash, " +
                                              "or expand the file where xacro is, 'xacro FILE.xacro > FILE.urdf', and give the .urdf");
  }
  if (xacro->status == 0) return xacro->out;
  const std::size_t skipped = xacro->errors.size() - std::min(xacro->errors.size(), kMostQuoted);
  throw Error(ErrorCode::kNotARobot,
              "'" + path + "': xacro failed with status " + std::to_string(xacro->status) + ": " + xacro->errors.substr(skipped));
}

std::string expanded(const std::string& path) {
  try {
    return expandXacro(path);
  } catch (const std::system_error& error) {
    throw Error(ErrorCode::kXacroMissing, "'" + path + "': xacro cannot be run: " + error.what());
  }
}

}  // namespace

RobotDescription readRobotDescription(const std::string& path) {
  checkReadable(path);
  return parseRobotDescription(isXacro(path) ? expanded(path) : readText(path), path);
}

}  // namespace collision_hulls
