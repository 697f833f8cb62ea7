// Commands in messages, which users copy into a shell.
#pragma once

#include <string>

namespace collision_hulls {

/// As one word of a command, whatever its letters.
inline std::string shellWord(const std::string& text) {
  const char* const kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,:=@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace collision_hulls
