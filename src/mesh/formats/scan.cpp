// A minimal scanner on string views: no copies, no locale, no exceptions but for the failures it reports.
#include "mesh/formats/scan.h"

#include <algorithm>

#include "mesh/formats/number.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLinesBetweenChecks = 1 << 16;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool endsLine(char c) {
  return c == '\n' || c == '\r' || c == '\f';
}

bool isBlank(char c) {
  return c == ' ' || c == '\t' || endsLine(c);
}

}  // namespace

bool LineScanner::next(std::string_view* line) {
  while (!rest_.empty()) {
    const auto length = static_cast<std::size_t>(std::find_if(rest_.begin(), rest_.end(), endsLine) - rest_.begin());
    *line = rest_.substr(0, length);
    if (next_number_ % kLinesBetweenChecks == 0) control_.check();
    number_ = next_number_++;
    const bool pair = rest_.substr(length, 2) == "\r\n";
    rest_.remove_prefix(std::min(length + (pair ? 2 : 1), rest_.size()));
    if (!std::all_of(line->begin(), line->end(), isBlank)) return true;
  }
  return false;
}

std::string_view nextWord(std::string_view* rest) {
  const char* const begin = std::find_if_not(rest->begin(), rest->end(), isBlank);
  const char* const end = std::find_if(begin, rest->end(), isBlank);
  rest->remove_prefix(static_cast<std::size_t>(end - rest->begin()));
  return {begin, static_cast<std::size_t>(end - begin)};
}

std::string_view withoutComment(std::string_view line) {
  for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1))
    if (i == 0 || isBlank(line[i - 1])) return line.substr(0, i);
  return line;
}

std::string inQuotes(std::string_view word) {
  constexpr std::size_t kLength = 40;
  std::string text(word.substr(0, kLength));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (word.size() > kLength ? "..." : "") + "'";
}

void failNotAMesh(const std::string& path, const std::string& reason, const std::string& remedy) {
  throw Error(ErrorCode::kNotAMesh, path + ": " + reason + "; " + remedy);
}

void failNotAMesh(const std::string& path, std::size_t line, const std::string& reason, const std::string& remedy) {
  failNotAMesh(path, "line " + std::to_string(line) + ": " + reason, remedy);
}

void failIndex(const std::string& path, std::size_t line, std::int64_t index, std::size_t vertices, int first) {
  throw Error(ErrorCode::kIndexOutOfRange, path + ": line " + std::to_string(line) + " names vertex " + std::to_string(index) +
                                               ", but there are " + std::to_string(vertices) + ", counted from " + std::to_string(first) +
                                               "; export it again");
}

void checkTriangleCount(const std::string& path, std::uint64_t triangles, std::size_t most) {
  if (triangles > most)
    throw Error(ErrorCode::kTooLarge, path + ": " + std::to_string(triangles) + " triangles or more, above the limit of " +
                                          std::to_string(most) + "; simplify the mesh or raise the limit");
}

std::string_view checkedText(std::string_view bytes, const std::string& path) {
  for (const std::string_view mark : {"\xFF\xFE", "\xFE\xFF"})
    if (bytes.substr(0, mark.size()) == mark) failNotAMesh(path, "is text in UTF-16", "save it in UTF-8");
  const std::size_t zero = bytes.find('\0');
  if (zero != std::string_view::npos) failNotAMesh(path, "holds a zero byte at offset " + std::to_string(zero) + ", so it is not text");
  if (bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark) bytes.remove_prefix(kByteOrderMark.size());
  return bytes;
}

double numberIn(std::string_view word, const std::string& path, std::size_t line) {
  double value = 0;
  if (!parseNumber(word, &value)) failNotAMesh(path, line, word.empty() ? "a number is missing" : inQuotes(word) + " is not a number");
  return value;
}

}  // namespace collision_hulls
