#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "pipeline/collision_model.h"
#include "pipeline/names.h"
#include "string_parts.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

std::string joined(const std::vector<std::string>& items, const std::string& between) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : between) + item;
  return text;
}

bool isRobotFile(const std::string& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".urdf" || extension == ".xacro";
}

Input robotInput(const std::string& path) {
  Input input;
  input.robot = readRobotDescription(path);
  input.find_package = defaultPackageFinder(path);
  return input;
}

Input fileInput(const std::string& path) {
  if (isRobotFile(path)) return robotInput(path);
  if (!isMeshFile(path)) {
    throw Error(ErrorCode::kUnsupportedFormat, "'" + path + "' has the extension '" + lowerExtension(path) +
                                                   "'; understood are .urdf and .xacro for a robot, and for a mesh " +
                                                   joined(meshExtensions(), " "));
  }
  Input input;
  input.kind = Input::Kind::kMesh;
  input.path = path;
  return input;
}

Input packageInput(const std::string& name, const std::string& folder) {
  const std::vector<std::string> found = robotDescriptionsIn(folder);
  if (found.size() == 1) return robotInput(found.front());
  if (found.empty()) {
    throw Error(ErrorCode::kFileNotFound,
                "package '" + name + "' (" + folder + ") has no .urdf or .xacro in its folders urdf and robots; give the file itself");
  }
  throw Error(ErrorCode::kNotARobot, "package '" + name + "' has " + std::to_string(found.size()) +
                                         " robot descriptions; give one of them instead of the package:\n  " + joined(found, "\n  "));
}

[[noreturn]] void throwNotFound(const std::string& input, bool package_tried) {
  std::string text = "INPUT '" + input + "' is no file and no package's folder (looked at '" +
                     (fs::current_path() / input).lexically_normal().string() + "')";
  if (!package_tried) throw Error(ErrorCode::kFileNotFound, text + "; check the path");
  const char* const packages = std::getenv("ROS_PACKAGE_PATH");
  throw Error(ErrorCode::kPackageNotFound, text + " and no known package (looked in ROS_PACKAGE_PATH, which is " +
                                               (packages && *packages ? "'" + std::string(packages) + "'" : "not set") +
                                               ", and in CMAKE_PREFIX_PATH); check the name, or source the workspace that holds it");
}

}  // namespace

Input openInput(const std::string& input) {
  std::error_code error;
  if (!input.empty() && fs::exists(fs::path(input) / "package.xml", error)) return packageInput(input, input);
  if (fs::exists(input, error) && !fs::is_directory(input, error)) return fileInput(input);
  const bool file_meant = input.empty() || input.find('/') != std::string::npos || isRobotFile(input) || isMeshFile(input);
  if (file_meant) throwNotFound(input, false);
  const std::optional<std::string> folder = defaultPackageFinder()(input);
  if (!folder) throwNotFound(input, true);
  return packageInput(input, *folder);
}

std::string defaultOutput(const Input& input) {
  if (input.kind == Input::Kind::kMesh) return "./" + fileName(fs::path(input.path).stem().string()) + "_collision";
  return "./" + outputPackage(input.robot.name);
}

}  // namespace collision_hulls
