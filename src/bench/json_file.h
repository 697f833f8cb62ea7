// JSON in files: how a benchmark and the processes that it starts talk to each other.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "storage/text_file.h"

namespace collision_hulls {

/// Throws Error for a file that cannot be read, and json::exception for one that is not JSON.
inline nlohmann::json readJson(const std::string& file) {
  return nlohmann::json::parse(readTextFile(file, ".json file"));
}

}  // namespace collision_hulls
