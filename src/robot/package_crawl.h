// The packages below given folders.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace collision_hulls {

bool isFile(const std::filesystem::path& path);
bool isFolder(const std::filesystem::path& path);
std::vector<std::filesystem::path> sortedEntries(const std::filesystem::path& folder);  ///< empty if the folder cannot be read

/// The innermost folder above a file that has a package.xml, below `top`; empty: none.
std::filesystem::path packageAround(const std::filesystem::path& file, const std::filesystem::path& top = {});

/// The text of a folder's package.xml; nullopt: it has none, or one that cannot be read or is too long for a manifest.
std::optional<std::string> manifestIn(const std::filesystem::path& folder);

/// A folder that is a package, by rospack's rules.
struct PackageFolder {
  std::string name;     ///< the manifest's, or the folder's if the manifest is of the old kind, broken or nameless
  bool broken = false;  ///< its package.xml is empty or not well-formed
};
std::optional<PackageFolder> packageAt(const std::filesystem::path& folder);

/// Where a package's files really are, without links: its folder, and those that its entries lead to in another folder of the same package.
/// A devel space is made of such links into the source.
std::vector<std::filesystem::path> realFolders(const std::filesystem::path& folder, const std::string& package);

/// Descends as rospack does: not into packages, hidden folders, or below CATKIN_IGNORE and rospack_nosubdirs. The first package of a
/// name counts.
class PackageCrawl {
 public:
  explicit PackageCrawl(const std::vector<std::filesystem::path>& roots);

  std::optional<std::string> find(const std::string& package) const;
  /// The package that holds a path; neither has links in it.
  std::optional<std::string> around(const std::filesystem::path& path) const;
  const std::vector<std::string>& brokenManifests() const { return broken_manifests_; }

 private:
  void visit(const std::filesystem::path& folder);

  std::map<std::string, std::string> packages_;
  std::set<std::filesystem::path> visited_, real_packages_;
  std::vector<std::string> broken_manifests_;
};

}  // namespace collision_hulls
