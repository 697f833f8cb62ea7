// Lines and words of a text, for the checks made before Assimp reads a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Iterates over the non-blank lines of a text. "\n", "\r", "\r\n" and "\f" end a line.
class LineScanner {
 public:
  /// `first`: the number of the text's first line.
  explicit LineScanner(std::string_view text, std::size_t first = 1) : rest_(text), next_number_(first) {}

  /// The next non-blank line without its end; false at the end of the text.
  bool next(std::string_view* line);

  std::size_t number() const { return number_; }   ///< of the line that next() returned last
  std::string_view rest() const { return rest_; }  ///< what follows that line
  /// Whether next() just skipped a line with only blanks, which other readers may count as a line; truly empty lines do not matter.
  bool passedBlanks() const { return passed_blanks_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
  std::size_t next_number_;
  bool passed_blanks_ = false;
};

/// Takes the next word off the front of `rest`; empty if there is none. Blanks and line ends separate words.
std::string_view nextWord(std::string_view* rest);

/// Parses the whole word as a decimal integer without leading zeros or a plus sign; false if it is not one, or too large.
bool parseInteger(std::string_view word, std::int64_t* value);

/// Throws kNotAMesh for a file, or for a line in it.
[[noreturn]] void failNotAMesh(const std::string& path, const std::string& reason);
[[noreturn]] void failNotAMesh(const std::string& path, std::size_t line, const std::string& reason);

/// Throws kTooLarge if a file announces more triangles than allowed.
void checkTriangleCount(const std::string& path, std::uint64_t triangles, std::size_t most);

/// Throws kNotAMesh if a text holds a zero byte.
void checkIsText(std::string_view bytes, const std::string& path);

}  // namespace collision_hulls
