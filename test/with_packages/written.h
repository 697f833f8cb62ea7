// Runs decompose for a consumer, in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

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

/// A description without what consumers do not collide with.
inline std::string withoutVisuals(std::string urdf) {
  const std::string start = "<visual", end = "</visual>";
  for (std::size_t at = 0; (at = urdf.find(start, at)) != std::string::npos;) {
    const std::size_t last = urdf.find(end, at);
    if (last == std::string::npos) break;
    urdf.erase(at, last + end.size() - at);
  }
  return urdf;
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
