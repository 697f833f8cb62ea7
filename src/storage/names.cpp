// Robots name links as they like; files, packages and elements may not be named so.
#include "storage/names.h"

#include "base/string_parts.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongestName = 200;  // bytes; file systems take 255, and numbers and extensions are added

// ASCII by hand: the C functions depend on the locale.
bool isUpper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool isLower(char c) {
  return c >= 'a' && c <= 'z';
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::string fileName(const std::string& text) {
  std::string result = text.substr(0, kLongestName);
  for (char& c : result) {
    if (!isUpper(c) && !isLower(c) && !isDigit(c) && c != '-' && c != '.') c = '_';
  }
  if (result.empty() || result.front() == '.') result.insert(0, "_");
  return result;
}

std::string robotFileName(std::string robot) {
  for (const std::string end : {".xacro", ".urdf"})
    if (lowerExtension(robot) == end && robot != end) robot.resize(robot.size() - end.size());
  return fileName(robot);
}

std::string packageName(const std::string& text) {
  std::string result = inLowerCase(text.substr(0, kLongestName));
  for (char& c : result) {
    if (!isLower(c) && !isDigit(c)) c = '_';
  }
  if (result.empty() || !isLower(result.front())) result.insert(0, "robot_");
  return result;
}

std::string UniqueNames::take(const std::string& wanted) {
  std::string name = wanted;
  for (int& number = last_.try_emplace(inLowerCase(wanted), 1).first->second; !taken_.insert(inLowerCase(name)).second;)
    name = wanted + "_" + std::to_string(++number);
  return name;
}

}  // namespace collision_hulls
