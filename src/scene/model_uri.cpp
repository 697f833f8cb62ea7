// The search order is: the folders of environment variables, the folders above the file, ~/.gazebo/models, and last a ROS package of that
// name. The first folder that contains the path wins.
#include "scene/model_uri.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "base/roots.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "robot/uri_checks.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr char kScheme[] = "model://";

std::vector<fs::path> modelFolders(const std::string& base) {
  std::vector<fs::path> folders;
  for (const char* variable : {"GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH"}) {
    const char* value = std::getenv(variable);
    std::istringstream list(value ? value : "");
    for (std::string folder; std::getline(list, folder, ':');) {
      if (!folder.empty()) folders.emplace_back(folder);
    }
  }
  const fs::path file = fs::absolute(base).lexically_normal();
  for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
    folders.push_back(folder);
    folders.push_back(folder / "models");
    if (folder == folder.root_path()) break;
  }
  if (const char* home = std::getenv("HOME")) folders.push_back(fs::path(home) / ".gazebo" / "models");
  return folders;
}

std::string resolveModel(const std::string& path, const std::string& base, const PackageFinder& find_package) {
  std::error_code error;
  const std::size_t name_end = std::min(path.find('/'), path.size());
  const std::string model = path.substr(0, name_end), rest = path.substr(name_end);
  checkStaysWithin(kScheme + path, model, fs::path(rest).relative_path().string());
  for (const fs::path& folder : modelFolders(base)) {
    if (fs::exists(folder / path, error)) return (folder / path).string();
  }
  const std::optional<std::string> package = find_package(model);
  if (package && fs::exists(*package + rest, error)) return *package + rest;
  throw Error(ErrorCode::kPackageNotFound,
              "'" + (kScheme + path) + "' was not found; add the folder that contains '" + model + "' to GAZEBO_MODEL_PATH or SDF_PATH");
}

}  // namespace

std::string resolveModelUri(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  if (uri.rfind(kScheme, 0) == 0) {
    checkCharacters(uri);
    const std::string path = resolveModel(uri.substr(sizeof kScheme - 1), base, find_package);
    checkRead(path);
    return path;
  }
  if (uri.rfind("http://", 0) == 0 || uri.rfind("https://", 0) == 0) {
    throw Error(ErrorCode::kUnsupportedFormat, "'" + uri + "' is on the web; download the file and give its path");
  }
  return resolveUri(uri, base, find_package);
}

}  // namespace collision_hulls
