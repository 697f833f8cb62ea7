// ROS packages found without ROS.
#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <mutex>
#include <set>
#include <sstream>

#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/text_file.h"
#include "robot/xml_spans.h"
#include "robot/xml_tree.h"
#include "string_parts.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) entries.push_back(at->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::vector<fs::path> foldersInVariable(const char* name) {
  const char* value = std::getenv(name);
  std::istringstream list(value ? value : "");
  std::vector<fs::path> folders;
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.push_back(fs::absolute(folder + "/").lexically_normal().parent_path());
  }
  return folders;
}

// The name that the folder has as a package, by rospack's rules; nullopt where it is none.
std::optional<std::string> packageName(const fs::path& folder) {
  const bool old_style = isFile(folder / "manifest.xml");
  if (!old_style && !isFile(folder / "package.xml")) return std::nullopt;
  const std::string folder_name = folder.filename().string();
  tinyxml2::XMLDocument manifest;
  if (old_style || manifest.LoadFile((folder / "package.xml").c_str()) != tinyxml2::XML_SUCCESS) return folder_name;
  const tinyxml2::XMLElement* root = manifest.RootElement();
  const tinyxml2::XMLElement* name = root ? root->FirstChildElement("name") : nullptr;
  return name && name->GetText() ? trimmed(name->GetText(), kXmlSpace) : folder_name;
}

// The packages below the folders of ROS_PACKAGE_PATH; the first of a name counts.
class Crawl {
 public:
  explicit Crawl(const std::vector<fs::path>& roots) {
    for (const fs::path& root : roots) visit(root);
  }

  std::optional<std::string> find(const std::string& package) const {
    const auto found = packages_.find(package);
    return found == packages_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  void visit(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error || !isFolder(real) || !visited_.insert(real).second) return;  // links may form loops
    if (isFile(folder / "CATKIN_IGNORE")) return;
    if (const auto name = packageName(folder)) {
      packages_.emplace(*name, folder.string());
      return;
    }
    if (isFile(folder / "rospack_nosubdirs")) return;
    for (const fs::path& entry : entriesOf(folder)) {
      if (entry.filename().string().front() != '.' && isFolder(entry)) visit(entry);
    }
  }

  std::map<std::string, std::string> packages_;
  std::set<fs::path> visited_;
};

// Where packages are looked for; the environment as it was when the finder was made, crawled once and when first needed.
class PackageSearch {
 public:
  explicit PackageSearch(const std::string& near)
      : roots_(foldersInVariable("ROS_PACKAGE_PATH")), prefixes_(foldersInVariable("CMAKE_PREFIX_PATH")) {
    if (near.empty()) return;
    const fs::path start = fs::absolute(near).lexically_normal();
    for (fs::path folder = isFolder(start) ? start : start.parent_path();; folder = folder.parent_path()) {
      if (!folder.filename().empty()) enclosing_.push_back(folder);
      if (folder == folder.root_path()) break;
    }
  }

  std::optional<std::string> find(const std::string& package) {
    if (package.empty() || package.front() == '.' || package.find('/') != std::string::npos) return std::nullopt;
    for (const fs::path& folder : enclosing_) {
      if (packageName(folder) == package) return folder.string();
    }
    if (const auto crawled = crawl().find(package)) return crawled;
    for (const fs::path& prefix : prefixes_) {
      if (isFolder(prefix / "share" / package)) return (prefix / "share" / package).string();
    }
    return findByFolderName(package);
  }

 private:
  const Crawl& crawl() {
    std::call_once(crawled_, [this] { crawl_ = std::make_unique<Crawl>(roots_); });
    return *crawl_;
  }

  // Descriptions are often passed on without the rest of a workspace, even without package.xml.
  std::optional<std::string> findByFolderName(const std::string& package) const {
    for (const fs::path& folder : enclosing_) {
      if (folder.filename() == package) return folder.string();
      if (isFolder(folder / package)) return (folder / package).string();
    }
    return std::nullopt;
  }

  std::vector<fs::path> roots_, prefixes_;
  std::vector<fs::path> enclosing_;  // innermost first
  std::once_flag crawled_;
  std::unique_ptr<const Crawl> crawl_;
};

}  // namespace

PackageFinder defaultPackageFinder(const std::string& near) {
  const auto search = std::make_shared<PackageSearch>(near);
  return [search](const std::string& package) { return search->find(package); };
}

namespace {

constexpr const char* kXacro = "xacro:";

/// Whether an element of a xacro file makes a part of a robot: it is a link, or a call of a macro.
bool makesParts(const XmlNode& element) {
  static const std::set<std::string> others{"xacro:include", "xacro:macro", "xacro:property", "xacro:arg", "xacro:insert_block"};
  if (element.name == "xacro:if" || element.name == "xacro:unless")
    return std::any_of(element.children.begin(), element.children.end(), makesParts);
  return element.name == "link" || (element.name.rfind(kXacro, 0) == 0 && others.count(element.name) == 0);
}

/// False for a xacro file of macros and properties that others include. What cannot be read is for the reader to complain about.
bool isDescription(const std::string& file) {
  if (fs::path(file).extension() != ".xacro") return true;
  try {
    const XmlNode root = parseXml(readTextFile(file, ".xacro file"), "'" + file + "'");
    return std::any_of(root.children.begin(), root.children.end(), makesParts);
  } catch (const Error&) {
    return true;
  }
}

}  // namespace

std::vector<std::string> robotDescriptionsIn(const std::string& package_folder) {
  std::vector<std::string> found;
  for (const char* extension : {".urdf", ".xacro"}) {
    for (const char* folder : {"robots", "urdf"}) {
      for (const fs::path& entry : entriesOf(fs::path(package_folder) / folder)) {
        if (entry.extension() == extension && isFile(entry)) found.push_back(entry.string());
      }
    }
  }
  std::vector<std::string> descriptions;
  std::copy_if(found.begin(), found.end(), std::back_inserter(descriptions), isDescription);
  return descriptions.empty() ? found : descriptions;
}

}  // namespace collision_hulls
