// The parameters are read once. The finder and the roots are made anew for each request, as packages come and go.
#include "places.h"

#include <ros/package.h>
#include <ros/this_node.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "collision_hulls/error.h"
#include "parameters.h"
#include "robot/package_crawl.h"
#include "robot/package_place.h"
#include "robot/uri_checks.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

/// The folder of a package as ROS knows it.
std::optional<std::string> rosPackage(const std::string& package) {
  try {
    const std::string folder = ros::package::getPath(package);
    return folder.empty() ? std::nullopt : std::optional(folder);
  } catch (const std::exception&) {
    return std::nullopt;  // rospack gives up at the first broken package.xml, whatever was asked; our own search notes it
  }
}

fs::path home() {
  const char* const folder = std::getenv("HOME");
  return folder ? folder : "";
}

fs::path rosHome() {
  if (const char* folder = std::getenv("ROS_HOME"); folder && *folder) return folder;
  return home() / ".ros";
}

/// The folder of the package that a folder is in; the folder itself without one.
std::string readRootAround(const std::string& folder) {
  for (fs::path above = folder; above.has_relative_path(); above = above.parent_path())
    if (packageAt(above)) return above.string();
  return folder;
}

/// A package that nodes wrote right below a folder; nullopt: there is none. Links are not followed.
std::optional<std::string> writtenPackage(const fs::path& folder, const std::string& name) {
  const fs::path place = folder / name;
  std::error_code error;
  if (!isPackageName(name) || !fs::is_directory(fs::symlink_status(place, error))) return std::nullopt;
  const std::optional<PackageFolder> package = packageAt(place);
  return package && package->name == name ? std::optional(place.string()) : std::nullopt;
}

}  // namespace

std::string NodePlaces::namespaceFolder() {
  return fs::path(ros::this_node::getNamespace()).relative_path().string();
}

NodePlaces::NodePlaces(const ros::NodeHandle& node)
    : output_root_(textParameter(node, "output_root")),
      base_(textParameter(node, "base")),
      output_(textParameter(node, "output")),
      read_roots_(readFolders(node, "read_roots")),
      package_path_(readFolders(node, "package_path")) {
  if (output_root_.empty()) output_root_ = rosHome() / "collision_hulls_output";
  if (output_root_.compare(0, 2, "~/") == 0) output_root_ = home() / output_root_.substr(2);  // a shell leaves it in _output_root:=~/models
  output_root_ = fs::absolute(output_root_).lexically_normal().string();
}

PackageFinder NodePlaces::packageFinder(const std::string& near) const {
  struct Answers {
    std::mutex mutex;
    std::map<std::string, std::optional<std::string>> known;
  };
  const std::vector<std::string> folders = {(fs::path(output_root_) / namespaceFolder()).string(), output_root_};
  return defaultPackageFinder(near, package_path_)
      .askingFirst([answers = std::make_shared<Answers>(), folders](const std::string& package) {
        const std::lock_guard<std::mutex> lock(answers->mutex);
        const auto [answer, is_new] = answers->known.try_emplace(package);
        if (is_new) answer->second = rosPackage(package);  // which crawls all packages where it finds none
        for (std::size_t i = 0; is_new && !answer->second && i < folders.size(); ++i) answer->second = writtenPackage(folders[i], package);
        return answer->second;
      });
}

/// Empty without a description's file, and where that is missing.
std::string NodePlaces::baseFolder() const {
  try {
    return base_.empty() ? "" : fs::path(resolveUri(base_, "", packageFinder(""))).parent_path().string();
  } catch (const Error&) {
    return "";
  }
}

Roots NodePlaces::roots() const {
  Roots roots;
  roots.read = read_roots_;
  roots.read.push_back(output_root_);
  for (const std::string& item : package_path_) roots.read.push_back(packagePlace(item).folder.string());
  const std::string base = baseFolder();
  if (!base.empty()) roots.read.push_back(readRootAround(base));
  roots.write = {output_root_};
  if (!output_.empty()) roots.outputs = {(fs::path(output_root_) / output_).string()};
  roots.read.insert(roots.read.end(), roots.outputs.begin(), roots.outputs.end());
  roots.package_with = [finder = packageFinder(base)](const std::string& path) { return finder.packageWith(path); };
  roots.more_read = "start the node with a ~read_roots that has its folder (read_roots:=DIR of decompose.launch)";
  roots.more_write = "start the node with another ~output_root (output_root:=DIR of decompose.launch), or choose a folder below it";
  return roots;
}

std::string NodePlaces::output(const std::string& wanted) const {
  return writablePath((fs::path(output_root_) / wanted).lexically_normal().string());
}

}  // namespace collision_hulls
