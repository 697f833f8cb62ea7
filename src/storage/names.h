// Names that a file system, a ROS package and a robot description accept, each given out once.
#pragma once

#include <map>
#include <set>
#include <string>

namespace collision_hulls {

/// A file or folder name of letters, digits, '_', '-' and '.', which is not hidden and not longer than file systems take.
std::string fileName(const std::string& text);

/// The same of a robot, for files of its model: some robots are named after their descriptions, extension and all.
std::string robotFileName(std::string robot);

/// A legal ROS package name: lower-case letters, digits and '_', a letter first.
std::string packageName(const std::string& text);

/// Hands out names that differ also where upper and lower case do not count, as on some file systems.
class UniqueNames {
 public:
  /// `wanted`, or `wanted` with a number added where it was taken before.
  std::string take(const std::string& wanted);

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> last_;  // number tried, by the name that was wanted
};

}  // namespace collision_hulls
