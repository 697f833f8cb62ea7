// What INPUT means: a package, a robot description or a mesh.
#include "collision_hulls/pipeline/input.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

#include "base/counted.h"
#include "base/nearest_name.h"
#include "base/shell_word.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/mesh_uses.h"
#include "robot/xacro.h"
#include "storage/names.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

bool isRobotFile(const std::string& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".urdf" || extension == ".xacro";
}

Input robotInput(const std::string& path, const InputOptions& options, const RunControl& control) {
  Input input;
  input.find_package = defaultPackageFinder(path, options.package_path);
  const bool ignores = options.may_ignore_arguments && lowerExtension(path) != ".xacro";
  input.robot = readRobotDescription(path, control, options.package_path, ignores ? std::vector<std::string>() : options.xacro_arguments);
  return input;
}

/// What of fit_scene takes a file that is neither a robot nor a mesh; empty: nothing. Xacro makes such files, too.
std::string useInFitScene(const std::string& path) {
  std::string extension = lowerExtension(path);
  if (extension == ".xacro") extension = lowerExtension(fs::path(path).stem().string());
  return extension == ".srdf" ? "--srdf" : extension == ".sdf" || extension == ".world" ? "--scene" : "";
}

Input fileInput(const std::string& path, const InputOptions& options, const RunControl& control) {
  const std::string use = useInFitScene(path), extension = lowerExtension(path);
  if (use.empty() && isRobotFile(path)) return robotInput(path, options, control);
  if (!isMeshFile(path)) {
    const std::string taken = extension == ".xacro" ? "takes such files, once xacro has expanded them, as " : "takes such files as ";
    throw Error(ErrorCode::kUnsupportedFormat,
                "'" + path + "' has the extension '" + (extension == ".xacro" ? fs::path(path).stem().extension().string() : "") +
                    extension + "', which is not supported" + (use.empty() ? "" : " here (fit_scene " + taken + use + ")") +
                    "; give a .urdf or .xacro file for a robot, or a mesh (" + listed(meshExtensions(), " ") + ")");
  }
  if (!options.may_ignore_arguments) checkTakesArguments(path, options.xacro_arguments);
  Input input;
  input.kind = Input::Kind::kMesh;
  input.path = path;
  return input;
}

/// Where a search ended, if it did not see all.
std::string cutShort(const FoundDescriptions& found) {
  return found.cut_after == 0 ? "" : " among the first " + std::to_string(found.cut_after) + " files and folders, where the search ended";
}

/// One of them is to be chosen.
std::string commandsFor(const FoundDescriptions& found, const InputOptions& options) {
  constexpr std::size_t kMostListed = 12;
  const std::vector<std::string>& descriptions = found.files;
  const std::string counted_all = counted(descriptions.size(), found.are_parts ? "file" : "robot description") + cutShort(found);
  std::string text = counted_all +
                     (found.are_parts ? ", none of which seems to make a robot, as they define macros for other files: give the "
                                        "description that calls them, which may be in another package, or try"
                                      : "; run") +
                     (descriptions.size() > 1 ? " one of" : "");
  for (std::size_t i = 0; i < std::min(descriptions.size(), kMostListed); ++i)
    text += "\n  " + options.program + " " + shellWord(descriptions[i]) + (options.words.empty() ? "" : " " + options.words);
  if (descriptions.size() > kMostListed) text += "\n  or with one of " + std::to_string(descriptions.size() - kMostListed) + " more";
  return text;
}

Input packageInput(const std::string& name, const std::string& folder, const InputOptions& options, const RunControl& control) {
  FoundDescriptions found{robotDescriptionsIn(folder)};
  if (found.files.size() != 1) {
    FoundDescriptions below = robotDescriptionsBelow(folder);
    if (found.files.empty() || below.are_parts) found = std::move(below);
  }
  if (found.files.size() == 1 && found.cut_after == 0) return robotInput(found.files.front(), options, control);
  if (found.files.empty()) {
    throw Error(ErrorCode::kFileNotFound, "package '" + name + "' (" + folder + ") has no .urdf or .xacro file" + cutShort(found) +
                                              "; give the package or the file that describes the robot");
  }
  throw Error(ErrorCode::kNotARobot, "package '" + name + "' has " + commandsFor(found, options));
}

/// Of an output for a single mesh, the file with all hulls; empty for any other folder.
std::string hullsOfMesh(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / "report.json", error)) return "";
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string(), ending = "_hulls.obj";
    if (name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0) return at->path().string();
  }
  return "";
}

/// What to do about a file that is not there: its folder may have one of nearly that name.
std::string meantBy(const fs::path& file) {
  constexpr int kMostEntries = 1000;
  std::vector<std::string> names;
  std::error_code error;
  int entries = 0;
  for (fs::directory_iterator at(fs::path(".") / file.parent_path(), error), end; !error && at != end && ++entries < kMostEntries;
       at.increment(error))
    if (isRobotFile(at->path().string()) || isMeshFile(at->path().string())) names.push_back(at->path().filename().string());
  std::sort(names.begin(), names.end());
  const std::string meant = didYouMean(file.filename().string(), names);
  return meant.empty() ? "; check the path" : meant;
}

[[noreturn]] void throwNotFound(const std::string& input, bool package_tried, const InputOptions& options) {
  std::error_code error;
  const std::string place = fs::absolute(fs::path(".") / input, error).lexically_normal().string();  // empty: the working folder is gone
  if (!input.empty() && fs::is_directory(input, error)) {
    const FoundDescriptions below = robotDescriptionsBelow(input);
    const std::string none = below.cut_after == 0 ? "" : "it has no description" + cutShort(below) + "; ";
    const std::string hulls = hullsOfMesh(input);
    if (!hulls.empty())
      throw Error(ErrorCode::kFileNotFound,
                  "folder '" + input + "' is the output for a single mesh; give '" + hulls + "', which has all of its hulls");
    throw Error(ErrorCode::kFileNotFound,
                "folder '" + input + "' is not a package: '" + place + "' has no package.xml; " +
                    (below.files.empty() ? none + "give a package, a .urdf or .xacro file, or a mesh; 'batch' takes folders of meshes"
                                         : "it has " + commandsFor(below, options)));
  }
  if (isRobotFile(input) || isMeshFile(input))
    throw Error(ErrorCode::kFileNotFound, "'" + input + "' does not exist" +
                                              (place == input || place.empty() ? "" : " (looked for '" + place + "')") + meantBy(input));
  const std::string text =
      "'" + input + "' is neither a file nor the folder of a package" + (place == input || place.empty() ? "" : " ('" + place + "')");
  if (!package_tried) throw Error(ErrorCode::kFileNotFound, text + "; check the path");
  const char* const packages = std::getenv("ROS_PACKAGE_PATH");
  throw Error(ErrorCode::kPackageNotFound,
              text + ", and no package of that name was found in ROS_PACKAGE_PATH (" +
                  (packages && *packages ? "'" + std::string(packages) + "'" : "not set") +
                  ") or CMAKE_PREFIX_PATH; check the name, source its workspace, or say where it is with --package-path DIR");
}

}  // namespace

Input openInput(const std::string& input, const InputOptions& options, const RunControl& control) {
  std::error_code error;
  if (packageOf(input)) return openInput(resolveUri(input, "", defaultPackageFinder("", options.package_path)), options, control);
  if (!input.empty() && fs::exists(fs::path(input) / "package.xml", error)) return packageInput(input, input, options, control);
  if (fs::exists(input, error) && !fs::is_directory(input, error)) return fileInput(input, options, control);
  const bool file_meant = input.empty() || input.find('/') != std::string::npos || isRobotFile(input) || isMeshFile(input);
  if (file_meant) throwNotFound(input, false, options);
  const std::optional<std::string> folder = defaultPackageFinder("", options.package_path)(input);
  if (!folder) throwNotFound(input, true, options);
  return packageInput(input, *folder, options, control);
}

std::string workOn(const Input& input, const Options& options, const RunControl& control) {
  if (input.kind == Input::Kind::kMesh) return "'" + input.path + "'";
  const std::vector<MeshUse> uses = meshUses(input.robot, {firstModelDecisions(options, input.robot, control)});
  std::set<std::string> links;
  for (const MeshUse& use : uses)
    if (use.options.action == Action::kDecompose) links.insert(use.link);
  return links.empty() ? "" : counted(decomposedUses(uses), "mesh", "meshes") + " of " + counted(links.size(), "link");
}

std::string defaultOutput(const Input& input) {
  if (input.kind == Input::Kind::kMesh) return "./" + fileName(fs::path(input.path).stem().string()) + "_collision";
  return "./" + packageName(input.robot.name) + "_collision";
}

}  // namespace collision_hulls
