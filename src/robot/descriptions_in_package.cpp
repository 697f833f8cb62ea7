// The robot descriptions that a package offers, without files that hold nothing but macros, materials and properties for others.
//
// Xacro files are judged as they are written, since expanding them takes a second each, and other packages. A file that consists of
// includes is a robot if one of the files that it includes adds parts to it. Calls of macros add parts only where there is a link: in the
// file, or in those that it includes.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/package_crawl.h"
#include "storage/text_file.h"
#include "xml/xml_tree.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr const char* kXacro = "xacro:";
constexpr std::size_t kMostEntries = 20'000;               // files and folders of a package that are looked at
constexpr int kDeepest = 6;                                // folders between a package and a description
constexpr int kMostIncludes = 50;                          // files that lead from one to the next,
constexpr std::size_t kMostBytes = std::size_t{32} << 20;  // and what is read of all: more files count as robots unread

bool isUrdf(const fs::path& path) {
  return lowerExtension(path.string()) == ".urdf";
}

/// Xacro makes other files than descriptions, too: arm.srdf.xacro and world.sdf.xacro say so.
bool isXacroOfRobot(const fs::path& path) {
  const std::string made = lowerExtension(path.stem().string());
  return lowerExtension(path.string()) == ".xacro" && made != ".srdf" && made != ".sdf";
}

bool isCondition(const XmlNode& element) {
  return element.name == "xacro:if" || element.name == "xacro:unless";
}

/// Whether an element adds a part to a robot: a link, or a macro call.
bool makesParts(const XmlNode& element) {
  static const std::set<std::string> others{"xacro:include", "xacro:macro", "xacro:property", "xacro:arg", "xacro:insert_block"};
  if (isCondition(element)) return std::any_of(element.children.begin(), element.children.end(), makesParts);
  return element.name == "link" || (element.name.rfind(kXacro, 0) == 0 && others.count(element.name) == 0);
}

/// What the elements include, as it is written.
std::vector<std::string> includedNames(const XmlNode& parent) {
  std::vector<std::string> names;
  for (const XmlNode& element : parent.children) {
    if (element.name == "xacro:include" || element.name == "include") names.push_back(element.attribute("filename"));
    if (!isCondition(element)) continue;
    const std::vector<std::string> more = includedNames(element);
    names.insert(names.end(), more.begin(), more.end());
  }
  return names;
}

/// Whether a text has a link, be it in a macro.
bool hasLink(const std::string& text) {
  const std::string tag = "<link", ends = " \t\r\n/>";
  for (std::size_t at = text.find(tag); at != std::string::npos; at = text.find(tag, at + 1)) {
    const std::size_t end = at + tag.size();
    if (end < text.size() && ends.find(text[end]) != std::string::npos) return true;
  }
  return false;
}

/// Parts of other descriptions by their names, such as arm.transmission.xacro and materials.urdf.xacro.
bool isNamedAsPart(const fs::path& path) {
  const std::string name = inLowerCase(path.filename().string()), first = name.substr(0, name.find('.'));
  return name.find(".gazebo") != std::string::npos || name.find(".transmission") != std::string::npos || first == "common" ||
         first == "const" || first == "materials";
}

/// All files, if none has another name.
std::vector<std::string> withoutNamedParts(const std::vector<std::string>& files) {
  std::vector<std::string> others;
  std::copy_if(files.begin(), files.end(), std::back_inserter(others), [](const std::string& file) { return !isNamedAsPart(file); });
  return others.empty() ? files : others;
}

/// Files of one package, judged by what is in them.
class Judge {
 public:
  explicit Judge(const fs::path& package) : package_(package.lexically_normal()) {
    const std::optional<PackageFolder> known = packageAt(package_);
    find_ = "$(find " + (known ? known->name : fs::absolute(package_ / "").parent_path().filename().string()) + ")/";
  }

  bool isDescription(const fs::path& path) { return judged(path).is_robot; }

  bool isIncluded(const fs::path& path) const { return included_.count(path.lexically_normal()) > 0; }

 private:
  struct Judgement {
    bool is_robot = false;
    bool has_links = false;  // or a file that it includes
  };

  /// Both for an unreadable file, so that its reader can say what is wrong.
  Judgement judged(const fs::path& path) {
    const fs::path file = path.lexically_normal();
    const auto [known, is_new] = judgements_.emplace(file, Judgement());  // of files that include each other, the first is asked
    if (!is_new) return known->second;
    ++depth_;
    const Judgement judgement = depth_ > kMostIncludes || bytes_ > kMostBytes ? Judgement{true, true} : look(file);
    --depth_;
    return judgements_[file] = judgement;
  }

  Judgement look(const fs::path& file) try {
    const std::string text = readTextFile(file.string(), "robot description");
    bytes_ += text.size();
    const XmlNode root = parseXml(text, "'" + file.string() + "'");
    const bool is_whole = !root.attribute("name").empty() && root.child("xacro:macro") == nullptr;
    Judgement result{false, hasLink(text)};
    for (const std::string& name : includedNames(root)) {
      const fs::path included = fileNamed(name, file);
      const bool is_here = isFile(included);
      if (is_here) included_.insert(included);
      // A file of another package adds parts, presumably.
      const Judgement other = is_here ? judged(included) : Judgement{is_whole, true};
      result.is_robot = result.is_robot || other.is_robot;
      result.has_links = result.has_links || other.has_links;
    }
    const bool has_parts = std::any_of(root.children.begin(), root.children.end(), makesParts);
    result.is_robot = result.is_robot || (has_parts && result.has_links);
    return result;
  } catch (const Error&) {
    return {true, true};
  }

  fs::path fileNamed(const std::string& name, const fs::path& includer) const {
    const bool in_package = name.rfind(find_, 0) == 0;
    return (in_package ? package_ / name.substr(find_.size()) : includer.parent_path() / name).lexically_normal();
  }

  fs::path package_;
  std::string find_;  // what an include of a file of this package begins with
  int depth_ = 0;
  std::size_t bytes_ = 0;
  std::map<fs::path, Judgement> judgements_;
  std::set<fs::path> included_;
};

/// Those that are robots. Those that others include come last.
std::vector<std::string> robotsAmong(const std::vector<std::string>& files, const fs::path& package) {
  Judge judge(package);
  std::vector<std::string> descriptions;
  std::copy_if(files.begin(), files.end(), std::back_inserter(descriptions),
               [&](const std::string& file) { return judge.isDescription(file); });
  std::stable_partition(descriptions.begin(), descriptions.end(), [&](const std::string& file) { return !judge.isIncluded(file); });
  return descriptions;
}

/// The same for files of several packages, package by package: what "$(find NAME)" means depends on it. All files of a package in which
/// none is a robot, but for those with names of parts.
void judgeByPackage(const std::vector<std::string>& files, const fs::path& folder, FoundDescriptions& found) {
  std::map<fs::path, std::vector<std::string>> by_package;
  for (const std::string& file : files) {
    const fs::path package = packageAround(file, folder);
    by_package[package.empty() ? folder : package].push_back(file);
  }
  found.are_parts = !files.empty();
  for (const auto& [package, of_package] : by_package) {
    const std::vector<std::string> robots = robotsAmong(of_package, package),
                                   chosen = robots.empty() ? withoutNamedParts(of_package) : robots;
    found.files.insert(found.files.end(), chosen.begin(), chosen.end());
    found.are_parts = found.are_parts && robots.empty();
  }
}

/// In an output of ours: without the copies of a description that --for writes for consumers with tags of their own.
void removeVariants(std::vector<std::string>& files) {
  const std::set<std::string> all(files.begin(), files.end());
  const auto is_variant = [&](const std::string& file) {
    const std::string stem = file.substr(0, file.rfind('.'));
    for (const std::string end : {"_drake", "_tesseract"})
      if (stem.size() > end.size() && stem.compare(stem.size() - end.size(), end.size(), end) == 0)
        return all.count(stem.substr(0, stem.size() - end.size()) + ".urdf") > 0;
    return false;
  };
  files.erase(std::remove_if(files.begin(), files.end(), is_variant), files.end());
}

}  // namespace

std::vector<std::string> robotDescriptionsIn(const std::string& package_folder) {
  std::vector<std::string> found;
  for (const auto is_description : {isUrdf, isXacroOfRobot}) {
    for (const char* folder : {"robots", "urdf"}) {
      for (const fs::path& entry : sortedEntries(fs::path(package_folder) / folder))
        if (is_description(entry) && isFile(entry)) found.push_back(entry.string());
    }
  }
  if (isFile(fs::path(package_folder) / "report.json")) removeVariants(found);
  const std::vector<std::string> robots = robotsAmong(found, package_folder);
  return robots.empty() && !found.empty() ? robotDescriptionsBelow(package_folder).files : robots;  // macros alone may be there
}

FoundDescriptions robotDescriptionsBelow(const std::string& folder) {
  std::vector<std::string> urdf, xacro;
  std::error_code error;
  std::size_t entries = 0;
  FoundDescriptions found;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, options, error), end; !error && at != end; at.increment(error)) {
    if (entries++ == kMostEntries) {
      found.cut_after = kMostEntries;
      break;
    }
    const fs::path& path = at->path();
    if (path.filename().string().front() == '.' || at.depth() == kDeepest) at.disable_recursion_pending();
    if (isUrdf(path) && isFile(path)) urdf.push_back(path.string());
    if (isXacroOfRobot(path) && isFile(path)) xacro.push_back(path.string());
  }
  for (std::vector<std::string>* files : {&urdf, &xacro}) std::sort(files->begin(), files->end());
  urdf.insert(urdf.end(), xacro.begin(), xacro.end());
  judgeByPackage(urdf, folder, found);
  return found;
}

}  // namespace collision_hulls
