// Runs decompose for a consumer, in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace fixtures {

/// Fast: what is tested are the files.
constexpr const char* kQuick = " -m bounding_box --no-validate --quiet";

/// Writes the model of `input` to `output`; false, with a failure, if that is not possible.
inline bool writeFor(const std::string& consumer, const std::string& input, const std::string& output, const std::string& more) {
  const std::string command =
      "'" PROGRAMS "/decompose' '" + input + "' -o '" + output + "' --for " + consumer + " " + more + " > '" + output + ".log' 2>&1";
  if (std::system(command.c_str()) == 0) return true;
  ADD_FAILURE() << command << "\n" << read(output + ".log");
  return false;
}

/// The bodies of a description: its text has the tag in comments and for Gazebo's sensors, too.
inline std::size_t collisions(const std::string& urdf) {
  std::size_t count = 0;
  for (const LinkDescription& link : readRobotDescription(urdf).links) count += link.collisions.size();
  return count;
}

/// The packages of robots beside the repository; none on machines that do not have them.
inline std::vector<std::string> sharedRobots() {
  std::vector<std::string> robots;
  const fs::path folder = fs::path(SHARED_DATA) / "robots";
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) robots.push_back(entry.path().string());
  return robots;
}

}  // namespace fixtures
}  // namespace collision_hulls
