// Robot descriptions from files: .urdf as they are, .xacro through the user's xacro program.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "base/run_program.h"
#include "base/shell_word.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
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
constexpr std::size_t kLongestPath = 64'000;  // [bytes] of ROS_PACKAGE_PATH: the kernel takes twice as much

bool isPackage(const fs::path& folder) {
  return isFile(folder / "package.xml");
}

/// The package that a file lies in; empty: none.
fs::path packageAround(const fs::path& file) {
  for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (isPackage(folder)) return folder;
  return {};
}

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
      if (isPackage(beside)) any.push_back(beside);
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

/// The name of a .urdf file that does not exist, beside a .xacro file: "arm.urdf", or "arm_2.urdf".
std::string freeUrdfBeside(const fs::path& file) {
  fs::path stem = fs::path(file).replace_extension();  // "arm" or "arm.urdf"
  if (lowerExtension(stem.string()) == ".urdf") stem.replace_extension();
  std::string urdf = stem.string() + ".urdf";
  std::error_code error;
  for (int number = 2; fs::exists(fs::symlink_status(urdf, error)); ++number) urdf = stem.string() + "_" + std::to_string(number) + ".urdf";
  return urdf;
}

/// What to do about an argument: the command that expands a file with a value for it, beside the file, as relative paths then still lead to
/// its meshes.
std::string runWith(const std::vector<std::string>& arguments, const std::string& path) {
  const fs::path file = fs::absolute(path).lexically_normal();
  std::string words;
  for (const std::string& argument : arguments) words += " " + shellWord(argument + ":=VALUE");
  return "run\n  xacro " + shellWord(file.string()) + words + " > " + shellWord(freeUrdfBeside(file)) + "\nand give the .urdf";
}

/// Runs xacro on a file, with 0 for each of these arguments; nullopt if there is no xacro.
std::optional<ProgramResult> runXacro(const std::string& path, const std::vector<std::string>& arguments,
                                      const std::vector<std::string>& package_path, const RunControl& control) {
  const fs::path file = fs::absolute(path);  // so that no file's name looks like an option
  std::vector<std::string> words = {"xacro", file.string()};
  for (const std::string& argument : arguments) words.push_back(argument + ":=0");
  return runProgram(words, control, {}, {"ROS_PACKAGE_PATH=" + packagePathFor(file, package_path)});
}

/// The argument without a value that xacro complains of; empty: of none.
std::string argumentWithoutValue(const ProgramResult& xacro) {
  return restOfLine(xacro.errors, "Undefined substitution argument ");
}

struct MissingArguments {
  std::vector<std::string> names;
  bool are_all = true;
};

/// The arguments without values: xacro names one at a time. With 0 for those, it may fail before it comes to the next.
MissingArguments argumentsWithoutValue(const std::string& path, const ProgramResult& first, const std::vector<std::string>& package_path,
                                       const RunControl& control) {
  MissingArguments missing;
  std::vector<std::string>& names = missing.names;
  std::string next = argumentWithoutValue(first);
  while (!next.empty() && names.size() < kMostArguments && std::find(names.begin(), names.end(), next) == names.end()) {
    names.push_back(next);
    const std::optional<ProgramResult> xacro = runXacro(path, names, package_path, control);
    missing.are_all = xacro && xacro->status == 0;
    next = missing.are_all || !xacro ? "" : argumentWithoutValue(*xacro);
  }
  return missing;
}

/// The error of a file that xacro did not expand, and what helps against it.
[[noreturn]] void throwFailed(const std::string& path, const ProgramResult& xacro, const std::vector<std::string>& package_path,
                              const RunControl& control) {
  const std::string processed = restOfLine(xacro.errors, "when processing file: "), source = processed.empty() ? path : processed;
  const std::string package = restOfLine(xacro.errors, "resource not found: ");
  if (!package.empty()) {
    throw Error(ErrorCode::kPackageNotFound, "package '" + package + "', which '" + source +
                                                 "' includes, was not found: install it and source its workspace, or give its folder, " +
                                                 "or the one above, with --package-path DIR");
  }
  const MissingArguments missing = argumentsWithoutValue(path, xacro, package_path, control);
  const std::vector<std::string>& arguments = missing.names;
  const std::string more = missing.are_all ? "" : " (xacro may ask for more once it has values for these)";
  if (arguments.size() == 1) {
    throw Error(ErrorCode::kNotARobot, "'" + path + "' needs a value for the argument '" + arguments.front() + "', which '" + source +
                                           "' uses and which has no default" + more + ": " + runWith(arguments, path));
  }
  if (!arguments.empty()) {
    throw Error(ErrorCode::kNotARobot, "'" + path + "' needs values for the arguments '" + listed(arguments, "', '") +
                                           "', which have no defaults" + more + ": " + runWith(arguments, path));
  }
  if (xacro.errors.find("xacro:arg: missing attribute 'default'") != std::string::npos) {
    const std::string name = argumentWithoutDefault(source, control);
    throw Error(ErrorCode::kNotARobot, "'" + path + "' cannot be expanded: the argument '" + name + "' in '" + source +
                                           "' has no default, without which xacro takes no value for it either. Add default=\"\" to its "
                                           "<xacro:arg>, " +
                                           runWith({name}, path));
  }
  const std::size_t skipped = xacro.errors.size() - std::min(xacro.errors.size(), kMostQuoted);
  throw Error(ErrorCode::kNotARobot, "'" + path + "': xacro failed with status " + std::to_string(xacro.status) +
                                         " (packages that it includes are found with --package-path DIR; arguments go to xacro " +
                                         "itself: xacro FILE.xacro NAME:=VALUE > FILE.urdf):\n" +
                                         trimmed(xacro.errors.substr(skipped), " \n"));
}

std::string expandXacro(const std::string& path, const std::vector<std::string>& package_path, const RunControl& control) {
  const std::optional<ProgramResult> xacro = runXacro(path, {}, package_path, control);
  if (!xacro) {
    throw Error(ErrorCode::kXacroMissing,
                "'" + path + "' is a xacro file, but 'xacro' is not on PATH: install it " +
                    "(ROS package xacro; on Debian build the branch noetic-devel of https://github.com/ros/xacro, and " +
                    "https://github.com/ros/roslint, in your workspace) and source your workspace's setup.bash, " +
                    "or run 'xacro FILE.xacro > FILE.urdf' on a machine that has it, and give the .urdf");
  }
  if (xacro->status == 0) return xacro->out;
  throwFailed(path, *xacro, package_path, control);
}

std::string expanded(const std::string& path, const std::vector<std::string>& package_path, const RunControl& control) {
  try {
    return expandXacro(path, package_path, control);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kTooLarge && error.code() != ErrorCode::kOutOfTime) throw;
    throw Error(error.code(), "'" + path + "': " + error.what());
  } catch (const std::system_error& error) {
    throw Error(ErrorCode::kXacroMissing, "'" + path + "': xacro cannot be run: " + error.what());
  }
}

/// Whether a file's text names another file, as one does that includes it.
bool mentions(const std::string& file, const std::string& name) try {
  return readTextFile(file, "robot description").find(name) != std::string::npos;
} catch (const Error&) {
  return false;
}

/// The other descriptions of the package that a file lies in, those that include the file first.
std::vector<std::string> descriptionsBeside(const fs::path& file) {
  const fs::path package = packageAround(file);
  if (package.empty()) return {};
  std::vector<std::string> found = robotDescriptionsIn(package.string());
  if (found.empty()) found = robotDescriptionsBelow(package.string()).files;
  if (std::find(found.begin(), found.end(), file.string()) != found.end()) return {};  // none of them is more of a robot
  std::stable_partition(found.begin(), found.end(), [&](const std::string& other) { return mentions(other, file.filename().string()); });
  return found;
}

/// What to give in place of a file that expands to no robot.
std::string insteadOf(const std::string& path) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<std::string> found = descriptionsBeside(fs::absolute(path).lexically_normal());
  if (found.empty()) return "often urdf/ROBOT.urdf.xacro";
  const std::size_t more = found.size() - std::min(found.size(), kMostNamed);
  found.resize(found.size() - more);
  return "such as '" + listed(found, "', '") + "'" + (more > 0 ? " or one of " + std::to_string(more) + " more" : "");
}

RobotDescription readXacro(const std::string& path, const std::string& text, const RunControl& control,
                           const std::vector<std::string>& package_path) {
  try {
    return parseRobotDescription(expanded(path, package_path, control), path, control);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kNoLinks) throw;
    const bool has_macros = text.find("<xacro:macro") != std::string::npos;
    throw Error(ErrorCode::kNoLinks, "'" + path + "' expands to a <robot> without a <link>" +
                                         (has_macros ? ": it defines macros for other files; give one that calls them, "
                                                     : "; give a file that describes a robot, ") +
                                         insteadOf(path));
  }
}

}  // namespace

RobotDescription readRobotDescription(const std::string& path, const RunControl& control, const std::vector<std::string>& package_path) {
  // Read in any case: the message about an unreadable file is better than xacro's.
  const std::string text = readTextFile(path, ".urdf or .xacro file", control);
  if (lowerExtension(path) == ".xacro") return readXacro(path, text, control, package_path);
  return parseRobotDescription(text, path, control);
}

}  // namespace collision_hulls
