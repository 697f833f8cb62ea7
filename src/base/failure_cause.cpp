// Reasons differ where they name a file, a link or a line. Without these, reasons of one cause are the same.
#include "base/failure_cause.h"

#include "base/counted.h"
#include "base/string_parts.h"

namespace collision_hulls {
namespace {

constexpr const char *kIsEqualTo = "' is equal to '", *kBecause = "': ";  // in the reason of a copy

/// Erases a part of a text wherever it stands; `whole_word`: with what is before it, back to a space or quote.
void eraseAll(const std::string& part, bool whole_word, std::string& text) {
  for (std::size_t at = 0; !part.empty() && (at = text.find(part, at)) != std::string::npos;) {
    const std::size_t begin = whole_word && at > 0 ? text.find_last_of(" '", at - 1) + 1 : at;  // 0 if there is none
    text.erase(begin, at + part.size() - begin);
    at = begin;
  }
}

void eraseLineNumbers(std::string& text) {
  for (const std::string line : {"', line ", ": line "}) {
    for (std::size_t at = 0; (at = text.find(line, at)) != std::string::npos;) {
      at += line.size();
      text.erase(at, text.find_first_not_of("0123456789", at) - at);
    }
  }
}

}  // namespace

std::string failureCause(std::string reason, std::string uri, const std::string& link, Folder folder) {
  const std::string begin = "'" + uri + kIsEqualTo, because = kBecause;
  if (const std::size_t end = reason.find(because, begin.size()); reason.rfind(begin, 0) == 0 && end != std::string::npos) {
    uri = reason.substr(begin.size(), end - begin.size());
    reason.erase(0, end + because.size());
  }
  eraseAll(lastPart(uri), folder == Folder::kLeftOut, reason);
  eraseAll("'" + link + "'", false, reason);
  eraseAll("[" + link + "]", false, reason);
  eraseLineNumbers(reason);
  return reason;
}

std::string reasonOfCopy(const std::string& uri, const std::string& first, const std::string& reason) {
  return "'" + uri + kIsEqualTo + first + kBecause + reason;
}

std::string theSameFor(std::size_t more, std::size_t links) {
  return " (the same for " + std::to_string(more) + " more, of " + counted(links, "link") + " in all)";
}

}  // namespace collision_hulls
