// catkin wants a maintainer, and nobody knows one better than the package that the robot comes from.
#include "pipeline/package/manifest.h"

#include <filesystem>
#include <set>

#include "base/roots.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "robot/package_crawl.h"
#include "robot/uri_checks.h"
#include "xml/xml_spans.h"
#include "xml/xml_tree.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr const char* kNobody = "  <maintainer email=\"nobody@example.invalid\">nobody</maintainer>\n";

/// The package.xml of the package around a file; empty if there is none.
std::string manifestAround(const std::string& file) {
  if (file.empty()) return "";
  const fs::path absolute = fs::absolute(file).lexically_normal();
  for (fs::path folder = absolute.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    if (!packageAt(folder)) continue;
    checkRead((folder / "package.xml").string());
    return manifestIn(folder).value_or("");
  }
  return "";
}

/// Whether a text can stand in one of UTF-8 as it is.
bool saysUtf8(const std::string& manifest) {
  const std::string declaration = inLowerCase(manifest.substr(0, manifest.find("?>")));
  return declaration.find("encoding") == std::string::npos || declaration.find("utf-8") != std::string::npos;
}

std::string maintainersOf(const std::string& input, const RunControl& control) try {
  const std::string manifest = manifestAround(input);
  if (manifest.empty() || !saysUtf8(manifest)) return kNobody;
  const XmlNode package = parseXml(manifest, "package.xml", control);
  std::string lines;
  for (const XmlNode* each : package.childrenNamed("maintainer"))
    if (!each->text.empty() && !each->attribute("email").empty())
      lines += "  <maintainer email=\"" + xmlEscaped(each->attribute("email")) + "\">" + xmlEscaped(each->text) + "</maintainer>\n";
  return lines.empty() ? kNobody : lines;
} catch (const Error& error) {
  if (error.code() == ErrorCode::kCancelled) throw;
  return kNobody;
}

/// The packages of the URIs in a description. What a package's name may hold needs no escape in XML.
void addPackages(const std::string& urdf, std::set<std::string>& packages) {
  if (urdf.empty()) return;
  for (const XmlElement& element : scanXml(urdf).elements) {
    const auto value = attributeValue(urdf, element, "filename");
    const std::string uri = value ? urdf.substr(value->begin, value->end - value->begin) : "";
    const auto package = uri.rfind("package://", 0) == 0 ? packageOf(uri) : std::nullopt;
    if (package && isPackageName(*package)) packages.insert(*package);
  }
}

std::string dependencies(const std::string& package, const RobotResult& result) {
  std::set<std::string> packages;
  addPackages(result.urdf, packages);
  for (const ModelResult& model : result.models) addPackages(model.urdf, packages);
  packages.erase(package);
  std::string lines;
  for (const std::string& each : packages) lines += "  <exec_depend>" + each + "</exec_depend>\n";
  return lines;
}

}  // namespace

std::string packageXml(const std::string& package, const RobotResult& result, const RunControl& control) {
  return "<?xml version=\"1.0\"?>\n<package format=\"2\">\n  <name>" + package +
         "</name>\n  <version>0.0.0</version>\n"
         "  <description>Convex collision model of a robot, made by collision_hulls " +
         version() + "; report.json says from what and how well it fits.</description>\n" +
         maintainersOf(result.report.input_path, control) +
         "  <license>as the robot description that it was made from</license>\n"
         "  <buildtool_depend>catkin</buildtool_depend>\n" +
         dependencies(package, result) + "  <export>\n    <architecture_independent/>\n  </export>\n</package>\n";
}

std::string cmakeLists(const std::string& package, const RobotResult& result) {
  std::set<std::string> folders{"config", "meshes", "urdf"}, files{"report.json"};
  if (result.report.options.html) files.insert("report.html");
  for (const auto& [file, text] : result.extra_files) {
    const fs::path path(file);
    if (path.has_parent_path())
      folders.insert(path.begin()->string());
    else
      files.insert(file);
  }
  return "cmake_minimum_required(VERSION 3.0.2)\nproject(" + package +
         ")\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
         "install(DIRECTORY " +
         listed(folders, " ") +
         " DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION} OPTIONAL)\n"
         "install(FILES " +
         listed(files, " ") + " DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})\n";
}

}  // namespace collision_hulls
