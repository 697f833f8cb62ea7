// What a user does next with an output: the last lines that the programs print.
#include <filesystem>
#include <set>
#include <string_view>

#include "base/counted.h"
#include "base/shell_word.h"
#include "collision_hulls/pipeline/output.h"
#include "pipeline/collision_model.h"
#include "storage/replace_folder.h"
#include "xml/xml_tree.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

/// Whether ROS, as it is set up here, finds this package in this folder.
bool isOnRosPath(const std::string& package, const fs::path& place) {
  const std::optional<std::string> known = defaultPackageFinder().knownPackage(package);
  std::error_code error;
  return known && fs::equivalent(*known, place, error);
}

std::string loadedBy(const std::string& file) {
  return "in your launch file:  <param name=\"robot_description\" textfile=\"" + xmlEscaped(file) + "\"/>\n";
}

/// ROS looks for no packages within a package.
bool isWithinPackage(const fs::path& place) {
  std::error_code error;
  for (fs::path above = place.parent_path(); above.has_relative_path(); above = above.parent_path())
    if (fs::exists(above / "package.xml", error)) return true;
  return false;
}

/// The packages that the URIs of a description name.
std::set<std::string> packagesIn(const std::string& urdf) {
  constexpr std::string_view kScheme = "package://";
  std::set<std::string> names;
  for (std::size_t at = urdf.find(kScheme); at != std::string::npos; at = urdf.find(kScheme, at)) {
    at += kScheme.size();
    names.insert(urdf.substr(at, urdf.find_first_of("/\"'", at) - at));
  }
  return names;
}

/// Where the packages lie that the output needs beside its own and that ROS does not find, though they were found from the input.
std::set<std::string> foldersOfOthers(const RobotResult& result, const std::string& own, const std::vector<std::string>& package_path) {
  const PackageFinder of_ros = defaultPackageFinder(), near = defaultPackageFinder(result.report.input_path, package_path);
  std::set<std::string> folders;
  for (const std::string& package : packagesIn(result.urdf)) {
    const auto known = package == own || of_ros.knownPackage(package) ? std::nullopt : near.knownPackage(package);
    if (known) folders.insert(fs::path(*known).parent_path().string());
  }
  return folders;
}

std::string asPackage(const std::string& package, const fs::path& place, const std::string& urdf, const RobotResult& result,
                      const std::vector<std::string>& package_path) {
  const fs::path folder = isWithinPackage(place) ? place : place.parent_path();
  const bool is_known = isOnRosPath(package, place);
  std::set<std::string> others = foldersOfOthers(result, package, package_path);
  if (!is_known) others.erase(folder.string());
  std::string folders = is_known ? "" : shellWord(folder.string());
  for (const std::string& other : others) folders += (folders.empty() ? "" : ":") + shellWord(other);
  const std::string path = folders.empty() ? ""
                                           : "export ROS_PACKAGE_PATH=" + folders + ":$ROS_PACKAGE_PATH" +
                                                 (is_known ? "\n" : "   # or move the folder into the src of your workspace\n");
  return "To use package '" + package + "':\n  " + (path.empty() ? "" : path + "  ") + loadedBy("$(find " + package + ")/" + urdf);
}

std::string hullsOf(const Report& report, const fs::path& place) {
  if (report.links.empty() || report.links.front().files.size() < 2) return "";
  const std::vector<std::string>& files = report.links.front().files;  // the OBJ of all hulls, then a file for each
  return "To use the hulls:\n  all in one file:  " + (place / files.front()).string() +
         "\n  in a URDF, one <collision> per hull:  <mesh filename=\"" + fileUri((place / files[1]).string()) + "\"/>" +
         (files.size() > 2 ? " to " + fs::path(files.back()).filename().string() : "") + "\n";
}

}  // namespace

std::string howToUse(const RobotResult& result, const std::string& output, const std::vector<std::string>& package_path) {
  const fs::path place = replacedFolder(output);
  const std::string written = "\nWritten to " + place.string() + "\n";
  if (result.single_mesh) return written + hullsOf(result.report, place);
  const Options& options = result.report.options;
  const std::string urdf = urdfFile(result.robot_name), file = (place / urdf).string();
  switch (options.uri) {
    case UriStyle::kPackage: return written + asPackage(outputPackage(options, output), place, urdf, result, package_path);
    case UriStyle::kFile: return written + "To use it, and leave the folder where it is:\n  " + loadedBy(file);
    case UriStyle::kRelative:
      return written + "To use it, load the file itself:\n  " + file +
             "\n  A robot_description parameter forgets the file's place, and with it the meshes: for ROS use --uri package or file.\n";
  }
  return written;
}

}  // namespace collision_hulls
