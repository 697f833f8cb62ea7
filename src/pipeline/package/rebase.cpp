// A file is named by its package only where that name leads back to the very file: another package of the name may come first.
#include "pipeline/package/rebase.h"

#include <filesystem>
#include <optional>

#include "collision_hulls/error.h"
#include "robot/package_crawl.h"
#include "storage/replace_folder.h"
#include "xml/xml_values.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr const char *kCollisionMesh = "robot/link/collision/geometry/mesh", *kVisualMesh = "robot/link/visual/geometry/mesh";

bool isTexture(const std::string& path) {
  return path == "robot/material/texture" || path == "robot/link/visual/material/texture";
}

/// nullopt where no known package holds the file, whose real path is `real`.
std::optional<std::string> uriInPackage(const fs::path& file, const fs::path& real, const PackageFinder& find_package) {
  for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    const auto package = packageAt(folder);
    if (!package) continue;
    const fs::path within = file.lexically_relative(folder);
    const auto known = find_package.knownPackage(package->name);
    std::error_code error;
    if (!known || !fs::equivalent(fs::path(*known) / within, real, error)) return std::nullopt;
    const std::string scheme = "file://";  // what fileUri() escapes is the same for packages
    return "package://" + package->name + fileUri("/" + within.string()).substr(scheme.size());
  }
  return std::nullopt;
}

/// Where the URIs of a description lead that nobody else could follow, asked once for each.
class Rebasing {
 public:
  Rebasing(const RobotDescription& robot, const PackageFinder& find_package, UriStyle style, const std::string& new_file,
           const RunControl& control)
      : base_(robot.path), find_package_(find_package), style_(style), folder_(fs::path(new_file).parent_path()), control_(control) {}

  /// nullopt for a URI that stays.
  std::optional<std::string> of(const std::string& uri) {
    control_.check();
    const auto [known, is_new] = uris_.try_emplace(uri);
    if (is_new) known->second = found(uri);
    return known->second;
  }

  std::set<std::string> newUris() const {
    std::set<std::string> uris;
    for (const auto& [old_uri, uri] : uris_)
      if (uri) uris.insert(*uri);
    return uris;
  }

 private:
  std::optional<std::string> found(const std::string& uri) const try {
    if (!isRelativeUri(uri) && !leadsToStandIn(uri, base_, find_package_)) return std::nullopt;
    return to(resolveUri(uri, base_, find_package_));
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kCancelled) throw;
    return std::nullopt;
  }

  std::string to(const std::string& file) const {
    const fs::path absolute = fs::absolute(file);
    std::error_code error;
    const fs::path real = fs::canonical(absolute.parent_path(), error) / absolute.filename();  // which may itself be a link
    if (style_ == UriStyle::kRelative) return real.lexically_relative(folder_).string();
    const auto in_package = style_ == UriStyle::kPackage ? uriInPackage(absolute.lexically_normal(), real, find_package_) : std::nullopt;
    return in_package.value_or(fileUri(real.string()));
  }

  const std::string base_;
  const PackageFinder& find_package_;
  const UriStyle style_;
  const fs::path folder_;  // of the new description
  const RunControl& control_;
  std::map<std::string, std::optional<std::string>> uris_;  // by the old ones
};

}  // namespace

bool leadsToStandIn(const std::string& uri, const std::string& base, const PackageFinder& find_package) try {
  const std::optional<std::string> package = packageOf(uri);
  return package && !find_package.knownPackage(*package) && !resolveUri(uri, base, find_package).empty();
} catch (const Error&) {
  return false;  // to nothing
}

RebasedDescription rebased(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                           const std::string& new_file, const std::map<std::string, std::string>& moved, const RunControl& control) {
  if (!options.rebase) return {robot, robot.path, {}};
  RebasedDescription result{robot, new_file, {}};
  Rebasing rebasing(robot, find_package, options.uri, new_file, control);
  const auto new_value = [&](const std::string& path, const std::string& uri) {
    const bool counts = path == kCollisionMesh ? !moved.count(uri) : path == kVisualMesh || isTexture(path);
    return counts ? rebasing.of(uri) : std::nullopt;
  };
  result.robot.text = withNewValues(robot.text, robot.path, "filename", new_value, control);
  for (LinkDescription& link : result.robot.links) {
    for (GeometryElement& visual : link.visuals) visual.uri = new_value(kVisualMesh, visual.uri).value_or(visual.uri);
    for (GeometryElement& collision : link.collisions) collision.uri = new_value(kCollisionMesh, collision.uri).value_or(collision.uri);
  }
  result.uris = rebasing.newUris();
  return result;
}

}  // namespace collision_hulls
