// Trimming, shortening and file extensions, in ASCII and independent of the locale.
#include "base/string_parts.h"

#include <algorithm>
#include <filesystem>

namespace collision_hulls {

std::string trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t begin = text.find_first_not_of(blanks), end = text.find_last_not_of(blanks);
  return begin == std::string_view::npos ? "" : std::string(text.substr(begin, end + 1 - begin));
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const auto is_inside = [&text](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
  std::size_t head = most / 2, tail = text.size() - most / 2;
  for (int i = 0; i < 3 && is_inside(head); ++i) --head;  // a character has four bytes at most
  for (int i = 0; i < 3 && tail < text.size() && is_inside(tail); ++i) ++tail;
  return text.substr(0, head) + "... (" + std::to_string(text.size()) + " bytes) ..." + text.substr(tail);
}

std::string inLowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::string lastPart(const std::string& uri) {
  return uri.substr(uri.find_last_of('/') + 1);
}

std::string lowerExtension(const std::string& path) {
  return inLowerCase(std::filesystem::path(path).extension().string());
}

}  // namespace collision_hulls
