// Numbers of things, for messages.
#pragma once

#include <string>

namespace collision_hulls {

/// "1 hull", "2 hulls"; `plural` for nouns that take more than an s.
inline std::string counted(std::size_t number, const std::string& noun, const std::string& plural = "") {
  return std::to_string(number) + " " + (number == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

}  // namespace collision_hulls
