// Lines and words of a text, for the checks before Assimp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// Goes through the lines of a text that are not blank. "\n", "\r", "\r\n" and "\f" end a line.
class LineScanner {
 public:
  /// `first`: the number of the text's first line.
  explicit LineScanner(std::string_view text, std::size_t first = 1) : rest_(text), next_number_(first) {}

  /// The next line without its end; false at the end of the text.
  bool next(std::string_view* line);

  std::size_t number() const { return number_; }   ///< of the line that next() gave
  std::string_view rest() const { return rest_; }  ///< what follows that line
  /// Whether a line before that one, that next() went past, holds blanks alone, which readers may count: not one that holds nothing.
  bool passedBlanks() const { return passed_blanks_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
  std::size_t next_number_;
  bool passed_blanks_ = false;
};

/// Takes the next word off the front of `rest`; empty if there is none. Blanks part words, and line ends too.
std::string_view nextWord(std::string_view* rest);

/// The whole word as a decimal integer without leading zeros or a plus sign; false if it is none that fits.
bool parseInteger(std::string_view word, std::int64_t* value);

/// Throws kNotAMesh for a file, or a line of it.
[[noreturn]] void failNotAMesh(const std::string& path, const std::string& reason);
[[noreturn]] void failNotAMesh(const std::string& path, std::size_t line, const std::string& reason);

/// Throws kTooLarge if a file announces more triangles than allowed.
void checkTriangleCount(const std::string& path, std::uint64_t triangles, std::size_t most);

/// Throws kNotAMesh for a text that holds a zero byte.
void checkIsText(std::string_view bytes, const std::string& path);

}  // namespace collision_hulls
