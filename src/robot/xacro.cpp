// What xacro does not say, its user learns here: which arguments lack a value, all at once and not one a run, and which are given in vain,
// as xacro takes any name without a word.
#include "robot/xacro.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "base/nearest_name.h"
#include "base/run_program.h"
#include "base/shell_word.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "robot/package_crawl.h"
#include "robot/package_place.h"
#include "storage/text_file.h"
#include "xml/xml_tree.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

// How much of xacro's own messages is quoted: the end, which has the reason.
constexpr std::size_t kMostQuoted = 2000;
constexpr std::size_t kMostArguments = 20;    // that are asked for one by one
constexpr std::size_t kLongestName = 200;     // of an argument, in a message
constexpr std::size_t kMostNamesShown = 12;   // of arguments that a file has, in a message
constexpr std::size_t kLongestPath = 64'000;  // [bytes] of ROS_PACKAGE_PATH: the kernel takes twice as much

const char* const kAssigns = ":=";

/// ROS_PACKAGE_PATH for xacro: folders in the order in which package:// URIs are looked up.
std::string packagePathFor(const fs::path& file, const std::vector<std::string>& given) {
  std::vector<fs::path> named, any;
  for (const std::string& item : given) {
    const PackagePlace place = packagePlace(item);
    (place.package.empty() ? any : named).push_back(fs::absolute(place.folder));
  }
  const fs::path package = packageAround(file);
  if (!package.empty())
    for (const fs::path& beside : sortedEntries(package.parent_path()))
      if (isFile(beside / "package.xml")) any.push_back(beside);
  const char* const ours = std::getenv("ROS_PACKAGE_PATH");
  std::string path;
  const auto add = [&](const std::string& folders) { path += (path.empty() ? "" : ":") + folders; };
  for (const fs::path& folder : named) add(folder.string());
  if (!package.empty()) add(package.string());
  add(ours && *ours ? ours : "/usr/share");
  for (const fs::path& folder : any)
    if (path.size() < kLongestPath) add(folder.string());
  return path;
}

/// What stands after `words` in a text, up to the end of its line, without blanks around it; empty: nothing.
std::string restOfLine(const std::string& text, const std::string& words) {
  const std::size_t found = text.find(words);
  if (found == std::string::npos) return "";
  const std::size_t begin = found + words.size();
  return trimmed(text.substr(begin, text.find('\n', begin) - begin), " ");
}

/// The name of the first <xacro:arg> below an element that has no default; empty: there is none.
std::string argumentWithoutDefault(const XmlNode& element) {
  for (const XmlNode& child : element.children) {
    if (child.name == "xacro:arg" && child.attributes.count("default") == 0) return child.attribute("name");
    const std::string below = argumentWithoutDefault(child);
    if (!below.empty()) return below;
  }
  return "";
}

/// The same of a file; "NAME" where it cannot be told.
std::string argumentWithoutDefault(const std::string& file, const RunControl& control) try {
  const std::string name = argumentWithoutDefault(parseXml(readTextFile(file, ".xacro file", control), file, control));
  return name.empty() ? "NAME" : name;
} catch (const Error& error) {
  if (error.code() == ErrorCode::kCancelled) throw;
  return "NAME";
}

void addDeclared(const XmlNode& element, std::set<std::string>& names) {
  for (const XmlNode& child : element.children) {
    if (child.name == "xacro:arg") names.insert(child.attribute("name"));
    addDeclared(child, names);
  }
}

/// The name of a .urdf file that does not exist, beside a .xacro file: "arm.urdf", or "arm_2.urdf".
std::string freeUrdfBeside(const fs::path& file) {
  fs::path stem = fs::path(file).replace_extension();  // "arm" or "arm.urdf"
  if (lowerExtension(stem.string()) == ".urdf") stem.replace_extension();
  std::string urdf = stem.string() + ".urdf";
  std::error_code error;
  for (int number = 2; fs::exists(fs::symlink_status(urdf, error)); ++number) urdf = stem.string() + "_" + std::to_string(number) + ".urdf";
  return urdf;
}

/// A file, what is given with it, and how xacro is run.
class Expansion {
 public:
  Expansion(const std::string& path, const std::vector<std::string>& arguments, const std::vector<std::string>& package_path,
            const RunControl& control)
      : path_(path),
        file_(fs::absolute(path)),  // so that no file's name looks like an option
        arguments_(arguments),
        package_path_("ROS_PACKAGE_PATH=" + packagePathFor(file_, package_path)),
        control_(control) {
    check();
  }

  std::string text() const {
    const std::optional<ProgramResult> xacro = run({});
    if (!xacro) {
      throw Error(ErrorCode::kXacroMissing,
                  "'" + path_ + "' is a xacro file, but 'xacro' is not on PATH: install it " +
                      "(ROS package xacro; on Debian build the branch noetic-devel of https://github.com/ros/xacro, and " +
                      "https://github.com/ros/roslint, in your workspace) and source your workspace's setup.bash, " +
                      "or run 'xacro FILE.xacro > FILE.urdf' on a machine that has it, and give the .urdf");
    }
    if (xacro->status != 0) throwFailed(*xacro);
    checkNames();
    return xacro->out;
  }

 private:
  /// nullopt: there is no xacro.
  std::optional<ProgramResult> run(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"xacro", file_.string()};
    words.insert(words.end(), arguments_.begin(), arguments_.end());
    words.insert(words.end(), more.begin(), more.end());
    return runProgram(words, control_, {}, {package_path_});
  }

  static std::string nameOf(const std::string& argument) { return argument.substr(0, argument.find(kAssigns)); }

  /// Refuses what xacro would drop, mostly without a word.
  void check() const {
    std::set<std::string> names;
    for (const std::string& argument : arguments_) {
      const std::string name = nameOf(argument), value = argument.substr(std::min(argument.size(), name.size() + 2));
      if (argument.find(kAssigns) == std::string::npos || name.empty() || name.front() == '-' || name.front() == '_')
        throw Error(ErrorCode::kBadOption, "'" + argument + "' is no argument for xacro: give NAME:=VALUE, as in prefix:=left_");
      if (trimmed(value, " \t\n").empty() || value.find(kAssigns) != std::string::npos)
        throw Error(ErrorCode::kBadOption, "'" + argument + "' has a value that xacro does not take (it is empty, or holds " + kAssigns +
                                               "), and the default of '" + name + "' would count: change the default in the file");
      if (!names.insert(name).second)
        throw Error(ErrorCode::kBadOption, "the argument '" + name + "' for xacro is given twice; leave one of them out");
    }
  }

  struct Missing {
    std::vector<std::string> names;
    bool are_all = true;
  };

  /// The arguments without values: xacro names one at a time. With 0 for those, it may fail before it comes to the next.
  Missing missingIn(const ProgramResult& first) const {
    const auto next_in = [](const ProgramResult& xacro) { return restOfLine(xacro.errors, "Undefined substitution argument "); };
    Missing missing;
    std::vector<std::string>& names = missing.names;
    std::string next = next_in(first);
    while (!next.empty() && names.size() < kMostArguments && std::find(names.begin(), names.end(), next) == names.end()) {
      names.push_back(next);
      std::vector<std::string> zeros;
      for (const std::string& name : names) zeros.push_back(name + kAssigns + "0");
      const std::optional<ProgramResult> xacro = run(zeros);
      missing.are_all = xacro && xacro->status == 0;
      next = missing.are_all || !xacro ? "" : next_in(*xacro);
    }
    return missing;
  }

  /// What to do about arguments: give their values, which a scene's file does not take, or expand the file beside itself, as relative paths
  /// then still lead to its meshes.
  std::string giving(const std::vector<std::string>& names) const {
    std::string added, words;
    for (const std::string& argument : arguments_) words += " " + shellWord(argument);
    for (const std::string& name : names) added += " " + shellWord(name + kAssigns + "VALUE");
    const fs::path file = file_.lexically_normal();
    return "where it is the robot of decompose, fit_scene or verify, add" + added + " to the command; else run\n  xacro " +
           shellWord(file.string()) + words + added + " > " + shellWord(freeUrdfBeside(file)) + "\nand give the .urdf";
  }

  /// The error of a file that xacro did not expand, and what helps against it.
  [[noreturn]] void throwFailed(const ProgramResult& xacro) const {
    const std::string processed = restOfLine(xacro.errors, "when processing file: "), source = processed.empty() ? path_ : processed;
    const std::string package = restOfLine(xacro.errors, "resource not found: ");
    if (!package.empty()) {
      throw Error(ErrorCode::kPackageNotFound, "package '" + package + "', which '" + source +
                                                   "' includes, was not found: install it and source its workspace, or give its " +
                                                   "folder, or the one above, with --package-path DIR");
    }
    const Missing missing = missingIn(xacro);
    const std::vector<std::string>& names = missing.names;
    const std::string more = missing.are_all ? "" : " (xacro may ask for more once it has values for these)";
    if (names.size() == 1) {
      throw Error(ErrorCode::kNotARobot, "'" + path_ + "' needs a value for the argument '" + names.front() + "', which '" + source +
                                             "' uses and which has no default" + more + ": " + giving(names));
    }
    if (!names.empty()) {
      throw Error(ErrorCode::kNotARobot, "'" + path_ + "' needs values for the arguments '" + listed(names, "', '") +
                                             "', which have no defaults" + more + ": " + giving(names));
    }
    if (xacro.errors.find("xacro:arg: missing attribute 'default'") != std::string::npos) {
      const std::string name = argumentWithoutDefault(source, control_);
      throw Error(ErrorCode::kNotARobot, "'" + path_ + "' cannot be expanded: the argument '" + name + "' in '" + source +
                                             "' has no default, without which xacro takes no value for it either. Add default=\"\" to " +
                                             "its <xacro:arg>, then " + giving({name}));
    }
    const std::size_t skipped = xacro.errors.size() - std::min(xacro.errors.size(), kMostQuoted);
    throw Error(ErrorCode::kNotARobot, "'" + path_ + "': xacro failed with status " + std::to_string(xacro.status) +
                                           " (packages that it includes are found with --package-path DIR; its arguments are given as " +
                                           "NAME:=VALUE):\n" + trimmed(xacro.errors.substr(skipped), " \n"));
  }

  /// Adds the arguments that a file declares or uses. False: not all of them can be told, as names are computed.
  bool addNames(const std::string& file, std::set<std::string>& names) const {
    const std::string text = readTextFile(file, ".xacro file", control_), use = "$(arg ";
    if (text.find("xacro.arg(") != std::string::npos || text.find("$(eval") != std::string::npos) return false;
    addDeclared(parseXml(text, file, control_), names);
    for (std::size_t at = text.find(use), end = 0; at != std::string::npos; at = text.find(use, end)) {
      const std::size_t begin = at + use.size();
      end = std::min(text.find_first_of(")\n$", begin), text.size());
      if (end < text.size() && text[end] == '$') return false;
      names.insert(trimmed(text.substr(begin, std::min(end - begin, kLongestName)), " "));
    }
    return true;
  }

  /// Refuses arguments that change nothing, as misspelt ones do, where the names of all can be told.
  void checkNames() const {
    std::set<std::string> names;
    const auto unknown = [&] {
      return std::find_if(arguments_.begin(), arguments_.end(), [&](const std::string& a) { return names.count(nameOf(a)) == 0; });
    };
    try {
      if (arguments_.empty() || !addNames(file_.string(), names) || unknown() == arguments_.end()) return;
      const std::optional<ProgramResult> listed_files = run({"--deps"});
      if (!listed_files || listed_files->status != 0) return;
      std::istringstream files(listed_files->out);
      for (std::string file; files >> file;)
        if (lowerExtension(file) != ".yaml" && lowerExtension(file) != ".yml" && !addNames(file, names)) return;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled) throw;
      return;  // such as a name with a blank, which the list does not tell from two
    }
    const auto lost = unknown();
    if (lost == arguments_.end()) return;
    const std::vector<std::string> known(names.begin(), names.end());
    const std::string name = nameOf(*lost), meant = didYouMean(name, known);
    throw Error(ErrorCode::kBadOption,
                "neither '" + path_ + "' nor a file that it includes has an argument '" + name + "'" +
                    (known.empty() ? "; leave out " + shellWord(*lost)
                                   : (meant.empty() ? "; they have " : meant + " They have ") + listedFirst(known, kMostNamesShown)));
  }

  const std::string& path_;
  const fs::path file_;
  const std::vector<std::string>& arguments_;
  const std::string package_path_;
  const RunControl& control_;
};

}  // namespace

void checkTakesArguments(const std::string& path, const std::vector<std::string>& arguments) {
  if (arguments.empty() || lowerExtension(path) == ".xacro") return;
  throw Error(ErrorCode::kBadOption,
              "'" + arguments.front() + "' is an argument for xacro, but '" + path + "' is not a .xacro file; leave it out");
}

std::string expandXacro(const std::string& path, const std::vector<std::string>& arguments, const std::vector<std::string>& package_path,
                        const RunControl& control) {
  try {
    return Expansion(path, arguments, package_path, control).text();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kTooLarge && error.code() != ErrorCode::kOutOfTime) throw;
    throw Error(error.code(), "'" + path + "': " + error.what());
  } catch (const std::system_error& error) {
    throw Error(ErrorCode::kXacroMissing, "'" + path + "': xacro cannot be run: " + error.what());
  }
}

}  // namespace collision_hulls
