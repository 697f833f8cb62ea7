// A URI comes from whoever wrote the file. It becomes a path, which a byte 0 would cut short.
#include "base/uri_text.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/string_parts.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

bool isTerminalControl(char c) {
  return isControl(c) && c != '\n' && c != '\t';
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

bool leadsOut(const std::string& path) {
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  return normal.is_absolute() || (!normal.empty() && *normal.begin() == "..");
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
