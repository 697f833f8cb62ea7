// A URI comes from whoever wrote the description. It becomes a path and, in its package's name, an argument of rospack: a byte 0 would cut
// either short, and a name such as "-h" would be an option.
#include "robot/uri_checks.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/string_parts.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

// ASCII by hand: the C functions depend on the locale.
bool isLetterOrDigit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

bool isPackageName(const std::string& text) {
  const auto allowed = [](char c) { return isLetterOrDigit(c) || c == '_' || c == '-' || c == '.'; };
  return !text.empty() && text.front() != '-' && text.front() != '.' && std::all_of(text.begin(), text.end(), allowed);
}

std::string shown(const std::string& text) {
  std::string result = shortened(text);
  std::replace_if(result.begin(), result.end(), isControl, '?');
  return result;
}

void checkCharacters(const std::string& uri) {
  if (uri.size() > kLongestUri)
    throw Error(ErrorCode::kFileNotFound, "'" + shown(uri) + "' has " + std::to_string(uri.size()) + " bytes, and a path has " +
                                              std::to_string(kLongestUri) + " at most; correct the URI");
  for (const std::string& text : {uri, percentDecoded(uri)}) {
    if (std::any_of(text.begin(), text.end(), isControl))
      throw Error(ErrorCode::kFileNotFound, "'" + shown(uri) + "' holds a control character, which no file is named with; remove it");
  }
}

void checkPackageName(const std::string& uri, const std::string& name) {
  if (isPackageName(name)) return;
  throw Error(ErrorCode::kFileNotFound, "'" + shown(name) + "' of '" + shown(uri) +
                                            "' is not a package's name: it takes letters, digits, '_', '-' and '.', and begins with a "
                                            "letter, a digit or '_'");
}

void checkStaysWithin(const std::string& uri, const std::string& name, const std::string& path) {
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  if (normal.is_absolute() || name == ".." || (!normal.empty() && *normal.begin() == ".."))
    throw Error(ErrorCode::kOutsideRoots,
                "'" + shown(uri) + "' leads out of '" + shown(name) + "'; name the package or model that it is in");
}

std::string percentDecoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size() && std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                        std::isxdigit(static_cast<unsigned char>(text[i + 2]));
    decoded += escape ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i];
    if (escape) i += 2;
  }
  return decoded;
}

}  // namespace collision_hulls
