// Packages, and files of packages that nobody has installed.
//
// A description is often passed on without the rest of its workspace: its meshes lie nearby, but the package that its URIs name does
// not exist. The search therefore goes from what is certain (--package-path NAME=DIR, ROS) to what is likely (a folder of that name, then
// the rest of the URI, in the folders above the description), nearest folder first. It never matches a file by its bare name alone, as
// robots have many files called base.stl, and it notes every folder that it used in place of a package.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>

#include "base/roots.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/package_crawl.h"
#include "robot/package_place.h"
#include "robot/uri_checks.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr std::size_t kMostNames = 20'000;  // of a folder in which a name in another case is looked for
constexpr std::size_t kMostAbove = 100;     // folders above a description that are searched: each has a path of its own, for every mesh

std::vector<fs::path> foldersInVariable(const char* name) {
  const char* value = std::getenv(name);
  std::istringstream list(value ? value : "");
  std::vector<fs::path> folders;
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.push_back(fs::absolute(folder + "/").lexically_normal().parent_path());
  }
  return folders;
}

// Innermost first, without the root of the file system, and kMostAbove at most. `path` is a file or a folder.
std::vector<fs::path> foldersAbove(const std::string& path) {
  std::vector<fs::path> folders;
  if (path.empty()) return folders;
  if (path.size() > kLongestUri)
    throw Error(ErrorCode::kBadOption, "packages near '" + shown(path) + "': this path has " + std::to_string(path.size()) +
                                           " bytes, and a path has " + std::to_string(kLongestUri) + " at most; give a shorter one");
  const fs::path start = fs::absolute(path).lexically_normal();
  for (fs::path folder = isFolder(start) ? start : start.parent_path(); folder.has_relative_path() && folders.size() < kMostAbove;
       folder = folder.parent_path()) {
    if (!folder.filename().empty()) folders.push_back(folder);
  }
  return folders;
}

bool mayBeRead(const std::string& folder) try {
  checkRead(folder);
  return true;
} catch (const Error&) {
  return false;
}

// A path as a sequence of names below a folder; empty for one that leads out of it.
fs::path within(const std::string& rest) {
  const fs::path normal = fs::path(rest).lexically_normal().relative_path();
  return normal.empty() || *normal.begin() == ".." || *normal.begin() == "." ? fs::path() : normal;
}

}  // namespace

PackagePlace packagePlace(const std::string& item) {
  const std::size_t equals = item.find('=');
  const bool named = equals != std::string::npos && isPackageName(item.substr(0, equals)) && !isFolder(item);
  const std::string folder = named ? item.substr(equals + 1) : item;
  if (folder.empty() || !isFolder(folder)) {
    throw Error(ErrorCode::kBadOption,
                "package path '" + item + "': there is no folder '" + folder + "'; give an existing folder, as DIR or NAME=DIR");
  }
  return {named ? item.substr(0, equals) : "", fs::absolute(folder + "/").lexically_normal().parent_path()};
}

// What the copies of a finder share. The environment counts as it was when the finder was made; manifests are read at their first use.
class PackageFinder::Search {
 public:
  Search(const std::string& near, const std::vector<std::string>& package_path, bool with_environment) : above_(foldersAbove(near)) {
    for (const std::string& text : package_path) {
      PackagePlace place = packagePlace(text);
      (place.package.empty() ? given_ : named_).push_back(std::move(place));
    }
    if (!with_environment) return;
    enclosing_ = above_;
    ros_ = foldersInVariable("ROS_PACKAGE_PATH");
    prefixes_ = foldersInVariable("CMAKE_PREFIX_PATH");
  }

  std::optional<std::string> named(const std::string& package) const {
    for (const PackagePlace& place : named_) {
      if (place.package == package) return place.folder.string();
    }
    return std::nullopt;
  }

  // The package that the description itself is in; of several with the same name the innermost.
  std::optional<std::string> enclosing(const std::string& package) {
    std::call_once(enclosing_read_, [this] {
      for (const fs::path& folder : enclosing_)
        if (const auto found = packageAt(folder)) enclosing_packages_.emplace(found->name, folder.string());
    });
    const auto found = enclosing_packages_.find(package);
    return found == enclosing_packages_.end() ? std::nullopt : std::optional(found->second);
  }

  // A package as its manifest says, or as it is installed.
  std::optional<std::string> known(const std::string& package) {
    std::call_once(crawled_, [this] { crawl(); });
    if (const auto found = ros_crawl_->find(package)) return found;
    for (const fs::path& prefix : prefixes_) {
      if (isFolder(prefix / "share" / package)) return (prefix / "share" / package).string();
    }
    return given_crawl_->find(package);
  }

  std::optional<std::string> byFolderName(const std::string& package) {
    std::vector<fs::path> candidates;
    for (const PackagePlace& place : given_) candidates.insert(candidates.end(), {place.folder / package, place.folder});
    for (const fs::path& folder : above_) candidates.insert(candidates.end(), {folder, folder / package});
    for (const fs::path& folder : candidates) {
      if (folder.filename() == package && isFolder(folder)) return remember(package, std::nullopt, folder);
    }
    return std::nullopt;
  }

  // `rest` of package `package`, which lies in `known` if it is known, wherever a folder near `base` or of --package-path could stand in.
  std::optional<std::string> file(const std::string& package, const std::optional<std::string>& known, const std::string& rest,
                                  const std::string& base) {
    const fs::path path = within(rest), name = within(package);
    if (path.empty() || name.empty()) return std::nullopt;
    for (const fs::path& folder : standIns(name, path, base)) {
      if (isFile(folder / path)) return remember(package, known, folder), (folder / path).string();
    }
    return std::nullopt;
  }

  std::optional<std::string> inOtherCase(const fs::path& path) {
    fs::path found = path.root_path();
    for (const fs::path& part : path.relative_path()) {
      fs::path next = found / part;
      std::error_code error;
      if (!fs::exists(next, error)) {
        const std::string name = nameInOtherCase(found.empty() ? "." : found, part.string());
        if (name.empty()) return std::nullopt;
        next = found / name;
      }
      found = std::move(next);
    }
    return isFile(found) ? std::optional(found.string()) : std::nullopt;
  }

  std::optional<std::string> nearbyInOtherCase(const std::string& package, const std::string& rest, const std::string& base) {
    const fs::path path = within(rest), name = within(package);
    if (path.empty() || name.empty()) return std::nullopt;
    for (const fs::path& folder : standIns(name, path, base))
      if (const auto file = isFolder(folder) ? inOtherCase(folder / path) : std::nullopt) return file;
    return std::nullopt;
  }

  // Of those that ROS knows or the package path has.
  std::string packageWith(const fs::path& path) {
    std::call_once(crawled_, [this] { crawl(); });
    for (const PackageCrawl* each : {ros_crawl_.get(), given_crawl_.get()}) {
      if (const auto folder = each->around(path)) return *folder;
    }
    return "";
  }

  std::string standIn(const std::string& package) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto used = stand_ins_.find(package);
    return used == stand_ins_.end() ? "" : used->second;
  }

  std::vector<std::string> notes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return notes_;
  }

 private:
  void crawl() {
    std::vector<fs::path> folders;
    for (const PackagePlace& place : given_) folders.push_back(place.folder);
    ros_crawl_ = std::make_unique<PackageCrawl>(ros_);
    given_crawl_ = std::make_unique<PackageCrawl>(folders);
    for (const PackageCrawl* each : {ros_crawl_.get(), given_crawl_.get()}) {
      for (const std::string& manifest : each->brokenManifests())
        note("'" + manifest + "' is empty or broken; its folder counts as a package of the folder's name");
    }
  }

  // The best first: folders of the package's name, then folders that may be the package under another name.
  std::vector<fs::path> standIns(const fs::path& name, const fs::path& path, const std::string& base) const {
    constexpr const char* kMeshes = "meshes";  // the usual subfolder, which URIs of flattened packages leave out
    constexpr std::size_t kNear = 2;           // folders in which even a bare file name is no accident
    std::vector<fs::path> above = foldersAbove(base);
    const std::size_t near = std::min(kNear, above.size());
    for (const fs::path& folder : above_) {
      if (std::find(above.begin(), above.end(), folder) == above.end()) above.push_back(folder);
    }
    std::vector<fs::path> folders;
    for (const PackagePlace& place : given_) folders.insert(folders.end(), {place.folder / name, place.folder / kMeshes / name});
    for (const fs::path& folder : above) folders.insert(folders.end(), {folder / name, folder / kMeshes / name});
    for (const PackagePlace& place : given_) folders.insert(folders.end(), {place.folder, place.folder / kMeshes});
    const bool bare = !path.has_parent_path();
    for (std::size_t i = 0; i < (bare ? near : above.size()); ++i) {
      folders.push_back(above[i]);
      if (!bare) folders.push_back(above[i] / kMeshes);
    }
    return folders;
  }

  // Each folder is read once, however many files are missed in it. Empty: there is no such name.
  std::string nameInOtherCase(const fs::path& folder, const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto [known, is_new] = names_.try_emplace(folder.string());
    if (is_new && mayBeRead(folder.string())) {
      std::error_code error;
      std::size_t entries = 0;
      for (fs::directory_iterator at(folder, error), end; !error && at != end && ++entries < kMostNames; at.increment(error)) {
        const std::string entry = at->path().filename().string();
        std::string& first = known->second[inLowerCase(entry)];
        if (first.empty() || entry < first) first = entry;
      }
    }
    const auto found = known->second.find(inLowerCase(name));
    return found == known->second.end() ? "" : found->second;
  }

  std::string remember(const std::string& package, const std::optional<std::string>& known, const fs::path& folder) {
    note("package '" + package + (known ? "' in '" + *known + "' lacks some of its files: " : "' was not found: ") + "the folder '" +
         folder.string() + "' was used in its place");
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!known) stand_ins_.emplace(package, folder.string());
    return folder.string();
  }

  void note(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
  }

  std::vector<fs::path> above_, enclosing_, ros_, prefixes_;
  std::vector<PackagePlace> named_, given_;
  std::once_flag enclosing_read_, crawled_;
  std::map<std::string, std::string> enclosing_packages_;  // by name
  std::unique_ptr<const PackageCrawl> ros_crawl_, given_crawl_;
  mutable std::mutex mutex_;  // guards all below
  std::vector<std::string> notes_;
  std::map<std::string, std::string> stand_ins_;                     // by package: the first one
  std::map<std::string, std::map<std::string, std::string>> names_;  // by folder and in lower case: of its entries
};

PackageFinder::PackageFinder() : PackageFinder(std::make_shared<Search>("", std::vector<std::string>(), false)) {}

PackageFinder::PackageFinder(std::shared_ptr<Search> search) : search_(std::move(search)) {}

PackageFinder PackageFinder::askingFirst(Lookup lookup) const {
  PackageFinder finder = *this;
  finder.first_ = std::move(lookup);
  return finder;
}

std::optional<std::string> PackageFinder::operator()(const std::string& package) const {
  if (const auto known = knownPackage(package)) return known;
  return isPackageName(package) ? search_->byFolderName(package) : std::nullopt;
}

std::optional<std::string> PackageFinder::knownPackage(const std::string& package) const {
  if (!isPackageName(package)) return std::nullopt;  // before `first_`, which may start a program
  std::optional<std::string> folder = search_->named(package);
  if (!folder) folder = search_->enclosing(package);
  if (!folder && first_) folder = first_(package);
  if (!folder) folder = search_->known(package);
  if (folder && allowPackage(*folder))
    for (const fs::path& each : realFolders(*folder, package)) allowPackage(each.string());
  return folder;
}

std::optional<std::string> PackageFinder::fileNearby(const std::string& package, const std::string& rest, const std::string& base) const {
  if (search_->named(package)) return std::nullopt;
  return search_->file(package, knownPackage(package), rest, base);
}

std::optional<std::string> PackageFinder::inOtherCase(const std::string& path) const {
  return search_->inOtherCase(path);
}

std::optional<std::string> PackageFinder::nearbyInOtherCase(const std::string& package, const std::string& rest,
                                                            const std::string& base) const {
  return search_->nearbyInOtherCase(package, rest, base);
}

std::string PackageFinder::standIn(const std::string& package) const {
  return search_->standIn(package);
}

std::string PackageFinder::packageWith(const std::string& path) const {
  return search_->packageWith(path);
}

std::vector<std::string> PackageFinder::notes() const {
  return search_->notes();
}

PackageFinder defaultPackageFinder(const std::string& near, const std::vector<std::string>& package_path) {
  return PackageFinder(std::make_shared<PackageFinder::Search>(near, package_path, true));
}

}  // namespace collision_hulls
