#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "pipeline/collision_model.h"
#include "pipeline/files.h"
#include "pipeline/names.h"
#include "pipeline/replace_folder.h"
#include "pipeline/stopwatch.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr const char* kReport = "report.json";

/// The files that an earlier output consists of, as its report names them; nullopt: it is none.
std::optional<std::set<fs::path>> filesOfEarlierOutput(const fs::path& folder) {
  try {
    const nlohmann::json report = nlohmann::json::parse(readText(folder / kReport));
    if (report.count("collision_hulls") == 0) return std::nullopt;
    std::set<fs::path> files{kReport};
    for (const nlohmann::json& file : report.at("files")) files.insert(file.get<std::string>());
    for (const nlohmann::json& link : report.at("links"))
      for (const nlohmann::json& file : link.at("files")) files.insert(file.get<std::string>());
    return files;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

void refuseForeign(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return;
  if (!fs::is_directory(folder, error)) {
    throw Error(ErrorCode::kNotOurOutput, "'" + folder.string() + "' is not a folder; choose another output");
  }
  if (fs::is_empty(folder, error)) return;
  const auto known = filesOfEarlierOutput(folder);
  if (!known) {
    throw Error(ErrorCode::kNotOurOutput,
                "'" + folder.string() +
                    "' holds something else than an earlier output (it has no report.json of this collision_hulls) and "
                    "is left alone; choose another output, or remove it yourself");
  }
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    const fs::path file = entry.path().lexically_relative(folder);
    if (entry.symlink_status(error).type() == fs::file_type::directory || known->count(file) > 0) continue;
    throw Error(ErrorCode::kNotOurOutput,
                "'" + folder.string() + "' holds '" + file.string() +
                    "', which is no part of the earlier output there, and is left alone; choose another output, or "
                    "move that file away");
  }
}

std::string packageXml(const std::string& robot_name) {
  return "<?xml version=\"1.0\"?>\n<package format=\"2\">\n  <name>" + outputPackage(robot_name) +
         "</name>\n  <version>0.0.0</version>\n"
         "  <description>Convex collision model of a robot, made by collision_hulls " +
         version() +
         "; report.json says from what and how well it fits.</description>\n"
         "  <maintainer email=\"nobody@example.com\">nobody</maintainer>\n"
         "  <license>as the robot description that it was made from</license>\n"
         "  <buildtool_depend>catkin</buildtool_depend>\n"
         "  <export>\n    <architecture_independent/>\n  </export>\n</package>\n";
}

/// So that the package can lie in the source folder of a workspace.
std::string cmakeLists(const RobotResult& result) {
  std::set<std::string> folders{"meshes", "urdf"};
  for (const auto& [file, text] : result.extra_files) folders.insert(fs::path(file).begin()->string());
  std::string names;
  for (const std::string& folder : folders) names += folder + " ";
  return "cmake_minimum_required(VERSION 3.0.2)\nproject(" + outputPackage(result.robot_name) +
         ")\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
         "install(DIRECTORY " +
         names +
         "DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION} OPTIONAL)\n"
         "install(FILES report.json DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})\n";
}

/// The folder that an output is written to, and the earlier output, if there is one, whose place it takes.
struct Folders {
  fs::path next, earlier;

  /// A file that the earlier output has, byte for byte, is taken over as a link: nothing to write, to bring to the disk, or to remove.
  void write(const fs::path& name, const std::string& text) const {
    const fs::path file = next / name, same = earlier / name;
    std::error_code error;
    if (fs::is_regular_file(fs::symlink_status(same, error)) && readText(same) == text) {
      fs::create_directories(file.parent_path(), error);
      fs::create_hard_link(same, file, error);
      if (!error) return;
    }
    writeText(file, text);
  }
};

void writeHulls(const ElementResult& element, MeshFormat format, const Folders& folders) {
  const std::vector<std::string>& files = element.report.files;
  const std::size_t hulls = element.hulls.size() - element.primitives.size();
  const std::size_t first = files.size() - hulls;  // the OBJ of all hulls stands before a file for each
  if (first > 0) folders.write(files.front(), encodeHullsObj(element.hulls, fileName(element.report.link)));
  for (std::size_t m = 0; m < hulls; ++m) {
    const fs::path file = files[first + m];
    folders.write(file, encodeHull(element.hulls[m], format, file.stem().string()));
  }
}

/// A folder is replaced by another one: not where that cannot be, nor under whoever works in it.
void refuseInUse(const fs::path& folder) {
  std::error_code none;
  const fs::path place = fs::canonical(folder, none), here = fs::current_path(none);
  if (place.empty()) return;
  const std::string advice = "; choose another output, such as a folder within it";
  if (std::mismatch(place.begin(), place.end(), here.begin(), here.end()).first == place.end())
    throw Error(ErrorCode::kUnwritableOutput,
                "output '" + folder.string() + "' would be replaced, and the current folder is there: '" + here.string() + "'" + advice);
  struct stat of_folder {
  }, of_parent{};
  if (stat(place.c_str(), &of_folder) == 0 && stat(place.parent_path().c_str(), &of_parent) == 0 && of_folder.st_dev != of_parent.st_dev)
    throw Error(ErrorCode::kUnwritableOutput,
                "output '" + folder.string() + "' is where something is mounted and cannot be replaced" + advice);
}

}  // namespace

void checkOutput(const std::string& output) {
  const fs::path folder = replacedFolder(output);
  refuseInUse(folder);
  refuseForeign(folder);
  checkFolderOf(folder);
}

// 6. Write.
bool writeOutput(RobotResult& result, const std::string& output, const RunControl& control) {
  if (allFailed(result.report)) return false;
  Stopwatch run;
  checkOutput(output);
  FolderReplacement replacement(output);
  const Folders folders{replacement.folder(), replacedFolder(output)};
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    control.check();
    Stopwatch stage;
    writeHulls(result.elements[i], result.report.options.format, folders);
    result.elements[i].report.seconds.write = result.report.links[i].seconds.write = stage.lap();
  }
  std::map<std::string, std::string> others = result.extra_files;
  if (!result.single_mesh) {
    others[urdfFile(result.robot_name)] = result.urdf;
    others["package.xml"] = packageXml(result.robot_name);
    others["CMakeLists.txt"] = cmakeLists(result);
  }
  result.report.files.clear();
  for (const auto& [file, text] : others) {
    folders.write(file, text);
    result.report.files.push_back(file);
  }
  result.report.seconds += run.lap();
  folders.write(kReport, toJson(result.report));
  refuseForeign(replacedFolder(output));
  control.check();
  replacement.commit();
  return true;
}

void writeReport(const Report& report, const std::string& file) {
  writeNamedFile(file, toJson(report));
}

}  // namespace collision_hulls
