// A minimal scanner on string views: no copies, no locale, no exceptions but for the failures it reports.
#include "mesh/formats/scan.h"

#include <algorithm>
#include <charconv>

namespace collision_hulls {
namespace {

constexpr std::string_view kLineEnds = "\n\r\f";
constexpr std::string_view kBlanks = " \t\n\r\f";

}  // namespace

bool LineScanner::next(std::string_view* line) {
  passed_blanks_ = false;
  while (!rest_.empty()) {
    const std::size_t length = std::min(rest_.find_first_of(kLineEnds), rest_.size());
    *line = rest_.substr(0, length);
    number_ = next_number_++;
    const bool pair = rest_.substr(length, 2) == "\r\n";
    rest_.remove_prefix(std::min(length + (pair ? 2 : 1), rest_.size()));
    if (line->find_first_not_of(kBlanks) != std::string_view::npos) return true;
    passed_blanks_ = passed_blanks_ || !line->empty();
  }
  return false;
}

std::string_view nextWord(std::string_view* rest) {
  rest->remove_prefix(std::min(rest->find_first_not_of(kBlanks), rest->size()));
  const std::string_view word = rest->substr(0, rest->find_first_of(kBlanks));
  rest->remove_prefix(word.size());
  return word;
}

bool parseInteger(std::string_view word, std::int64_t* value) {
  const std::string_view digits = word.substr(word.substr(0, 1) == "-" ? 1 : 0);
  if (digits.empty() || (digits.size() > 1 && digits[0] == '0')) return false;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), *value);
  return failure == std::errc() && end == word.data() + word.size();
}

void failNotAMesh(const std::string& path, const std::string& reason) {
  throw Error(ErrorCode::kNotAMesh, path + ": " + reason + "; check the file or export it again");
}

void failNotAMesh(const std::string& path, std::size_t line, const std::string& reason) {
  failNotAMesh(path, "line " + std::to_string(line) + ": " + reason);
}

void checkTriangleCount(const std::string& path, std::uint64_t triangles, std::size_t most) {
  if (triangles > most)
    throw Error(ErrorCode::kTooLarge, path + ": " + std::to_string(triangles) + " triangles or more, above the limit of " +
                                          std::to_string(most) + "; simplify the mesh or raise the limit");
}

void checkIsText(std::string_view bytes, const std::string& path) {
  const std::size_t zero = bytes.find('\0');
  if (zero != std::string_view::npos) failNotAMesh(path, "holds a zero byte at offset " + std::to_string(zero) + ", so it is not text");
}

}  // namespace collision_hulls
