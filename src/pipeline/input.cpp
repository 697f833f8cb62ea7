// What INPUT means: a package, a robot description or a mesh.
#include "collision_hulls/pipeline/input.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

#include "base/counted.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/mesh_uses.h"
#include "storage/names.h"

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

using PackagePath = std::vector<std::string>;

Input robotInput(const std::string& path, const PackagePath& package_path, const RunControl& control) {
  Input input;
  input.find_package = defaultPackageFinder(path, package_path);
  input.robot = readRobotDescription(path, control, package_path);
  return input;
}

Input fileInput(const std::string& path, const PackagePath& package_path, const RunControl& control) {
  if (isRobotFile(path)) return robotInput(path, package_path, control);
  if (!isMeshFile(path)) {
    throw Error(ErrorCode::kUnsupportedFormat, "'" + path + "' has the extension '" + lowerExtension(path) +
                                                   "', which is not supported; give a .urdf or .xacro file for a robot, or a mesh (" +
                                                   joined(meshExtensions(), " ") + ")");
  }
  Input input;
  input.kind = Input::Kind::kMesh;
  input.path = path;
  return input;
}

Input packageInput(const std::string& name, const std::string& folder, const PackagePath& package_path, const std::string& program,
                   const RunControl& control) {
  const std::vector<std::string> found = robotDescriptionsIn(folder);
  if (found.size() == 1) return robotInput(found.front(), package_path, control);
  if (found.empty()) {
    throw Error(ErrorCode::kFileNotFound,
                "package '" + name + "' (" + folder + ") has no .urdf or .xacro file in its folders urdf and robots; give the file itself");
  }
  throw Error(ErrorCode::kNotARobot, "package '" + name + "' has " + std::to_string(found.size()) + " robot descriptions; run one of\n  " +
                                         program + " " + joined(found, "\n  " + program + " "));
}

[[noreturn]] void throwNotFound(const std::string& input, bool package_tried) {
  std::error_code error;
  const std::string place = fs::absolute(fs::path(".") / input, error).lexically_normal().string();  // empty: the working folder is gone
  if (!input.empty() && fs::is_directory(input, error))
    throw Error(ErrorCode::kFileNotFound, "folder '" + input + "' is not a package: '" + place + "' has no package.xml; give a package, " +
                                              "a .urdf or .xacro file, or a mesh");
  if (isRobotFile(input) || isMeshFile(input))
    throw Error(
        ErrorCode::kFileNotFound,
        "'" + input + "' does not exist" + (place == input || place.empty() ? "" : " (looked for '" + place + "')") + "; check the path");
  const std::string text = "INPUT '" + input + "' is neither a file nor the folder of a package ('" + place + "')";
  if (!package_tried) throw Error(ErrorCode::kFileNotFound, text + "; check the path");
  const char* const packages = std::getenv("ROS_PACKAGE_PATH");
  throw Error(ErrorCode::kPackageNotFound,
              text + ", and no package of that name was found in ROS_PACKAGE_PATH (" +
                  (packages && *packages ? "'" + std::string(packages) + "'" : "not set") +
                  ") or CMAKE_PREFIX_PATH; check the name, source its workspace, or say where it is with --package-path DIR");
}

}  // namespace

Input openInput(const std::string& input, const PackagePath& package_path, const std::string& program, const RunControl& control) {
  std::error_code error;
  if (!input.empty() && fs::exists(fs::path(input) / "package.xml", error))
    return packageInput(input, input, package_path, program, control);
  if (fs::exists(input, error) && !fs::is_directory(input, error)) return fileInput(input, package_path, control);
  const bool file_meant = input.empty() || input.find('/') != std::string::npos || isRobotFile(input) || isMeshFile(input);
  if (file_meant) throwNotFound(input, false);
  const std::optional<std::string> folder = defaultPackageFinder("", package_path)(input);
  if (!folder) throwNotFound(input, true);
  return packageInput(input, *folder, package_path, program, control);
}

std::string workOn(const Input& input, const Options& options) {
  if (input.kind == Input::Kind::kMesh) return "'" + input.path + "'";
  const std::vector<MeshUse> uses = meshUses(input.robot, {modelDecisions(options, input.robot).front()});
  std::set<std::string> links;
  for (const MeshUse& use : uses)
    if (use.options.action == Action::kDecompose) links.insert(use.link);
  return counted(decomposedUses(uses), "mesh", "meshes") + " of " + counted(links.size(), "link");
}

std::string defaultOutput(const Input& input) {
  if (input.kind == Input::Kind::kMesh) return "./" + fileName(fs::path(input.path).stem().string()) + "_collision";
  return "./" + packageName(input.robot.name) + "_collision";
}

}  // namespace collision_hulls
