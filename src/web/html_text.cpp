// HTML has two ways to read text: in elements and attributes, where entities stand for characters, and in <script>, where nothing does and
// only "</script" and "<!--" matter. Each has its own escape here; nothing else writes foreign text into a page.
#include "web/html_text.h"

namespace collision_hulls {
namespace {

/// A control character that HTML does not allow. Bytes above ASCII are left to the browser, which shows those that are no UTF-8 as U+FFFD.
bool isForbidden(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\t' && c != '\n') || code == 0x7f;
}

std::string entity(char c) {
  switch (c) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    case '"': return "&quot;";
    case '\'': return "&#39;";
    default: return isForbidden(c) ? "\xEF\xBF\xBD" : std::string(1, c);
  }
}

}  // namespace

std::string escapedHtml(const std::string& text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) escaped += entity(c);
  return escaped;
}

std::string scriptJson(std::string json) {
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at)) json.replace(at, 1, "\\u003c");
  return json;
}

std::string grouped(std::size_t number) {
  constexpr std::size_t kGroup = 3;
  std::string text = std::to_string(number);
  for (std::size_t left = text.size(); left > kGroup;) text.insert(left -= kGroup, ",");
  return text;
}

}  // namespace collision_hulls
