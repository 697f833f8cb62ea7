// Finds packages without ROS: rospack itself gives up on the whole search at the first package.xml that it cannot read.
#include "robot/package_crawl.h"

#include <algorithm>

#include "base/string_parts.h"
#include "storage/files.h"
#include "xml/xml_spans.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr std::uintmax_t kMostManifest = std::uintmax_t{1} << 16;  // [bytes] of a package.xml

/// What the <name> of a package.xml says; empty: nothing. Throws XmlSyntaxError.
std::string nameIn(const std::string& manifest) {
  const std::vector<XmlElement> elements = scanXml(manifest).elements;
  const std::vector<std::size_t> names = childrenNamed(elements, 0, "name");
  if (names.empty()) return "";
  const std::size_t begin = elements[names.front()].tag_end;
  return trimmed(std::string_view(manifest).substr(begin, manifest.find('<', begin) - begin), kXmlSpace);
}

}  // namespace

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::vector<fs::path> sortedEntries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) entries.push_back(at->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

fs::path packageAround(const fs::path& file, const fs::path& top) {
  for (fs::path above = file.parent_path(); above != top && above.has_relative_path(); above = above.parent_path())
    if (isFile(above / "package.xml")) return above;
  return {};
}

std::optional<std::string> manifestIn(const fs::path& folder) {
  return contentOf(folder / "package.xml", kMostManifest);
}

std::optional<PackageFolder> packageAt(const fs::path& folder) {
  const std::string folder_name = folder.filename().string();
  if (isFile(folder / "manifest.xml")) return PackageFolder{folder_name};
  if (!isFile(folder / "package.xml")) return std::nullopt;
  const std::optional<std::string> text = manifestIn(folder);
  if (!text) return PackageFolder{folder_name, true};
  try {
    const std::string name = nameIn(*text);
    return PackageFolder{name.empty() ? folder_name : name};
  } catch (const XmlSyntaxError&) {
    return PackageFolder{folder_name, true};
  }
}

std::vector<fs::path> realFolders(const fs::path& folder, const std::string& package) {
  std::error_code error;
  std::vector<fs::path> folders{fs::canonical(folder, error)};
  if (error) return {};
  for (const fs::path& entry : sortedEntries(folder)) {
    if (!fs::is_symlink(entry, error) || !isFolder(entry)) continue;
    const fs::path target = fs::canonical(entry, error);
    const auto source = packageAt(target.parent_path());
    if (source && source->name == package) folders.push_back(target);
  }
  return folders;
}

PackageCrawl::PackageCrawl(const std::vector<fs::path>& roots) {
  for (const fs::path& root : roots) visit(root);
}

std::optional<std::string> PackageCrawl::find(const std::string& package) const {
  const auto found = packages_.find(package);
  return found == packages_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> PackageCrawl::around(const fs::path& path) const {
  for (fs::path folder = path; folder.has_relative_path(); folder = folder.parent_path())
    if (real_packages_.count(folder) > 0) return folder.string();
  return std::nullopt;
}

void PackageCrawl::visit(const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  if (error || !isFolder(real) || !visited_.insert(real).second) return;  // symbolic links may form loops
  if (isFile(folder / "CATKIN_IGNORE")) return;
  if (const auto package = packageAt(folder)) {
    packages_.emplace(package->name, folder.string());
    for (const fs::path& each : realFolders(real, package->name)) real_packages_.insert(each);
    if (package->broken) broken_manifests_.push_back((folder / "package.xml").string());
    return;
  }
  if (isFile(folder / "rospack_nosubdirs")) return;
  for (const fs::path& entry : sortedEntries(folder)) {
    if (entry.filename().string().front() != '.' && isFolder(entry)) visit(entry);
  }
}

}  // namespace collision_hulls
