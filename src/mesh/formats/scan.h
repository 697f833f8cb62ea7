// Lines and words of a text, and the errors that name them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "collision_hulls/control.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

/// Iterates over the non-blank lines of a text. "\n", "\r", "\r\n" and "\f" end a line.
class LineScanner {
 public:
  /// `first`: the number of the text's first line.
  LineScanner(std::string_view text, const RunControl& control, std::size_t first = 1)
      : rest_(text), control_(control), next_number_(first) {}

  /// The next non-blank line without its end; false at the end of the text.
  bool next(std::string_view* line);

  std::size_t number() const { return number_; }   ///< of the line that next() returned last
  std::string_view rest() const { return rest_; }  ///< what follows that line

 private:
  std::string_view rest_;
  const RunControl& control_;
  std::size_t number_ = 0;
  std::size_t next_number_;
};

/// Takes the next word off the front of `rest`; empty if there is none. Blanks and line ends separate words.
std::string_view nextWord(std::string_view* rest);

/// The text up to the first word that begins with '#': "1.#QNAN" is no number followed by a comment.
std::string_view withoutComment(std::string_view line);

/// A word for a message: in quotes, printable and not too long.
std::string inQuotes(std::string_view word);

/// Throws kNotAMesh for a file, or for a line in it.
constexpr const char* kUsualRemedy = "check the file or export it again";
[[noreturn]] void failNotAMesh(const std::string& path, const std::string& reason, const std::string& remedy = kUsualRemedy);
[[noreturn]] void failNotAMesh(const std::string& path, std::size_t line, const std::string& reason,
                               const std::string& remedy = kUsualRemedy);

/// Throws kIndexOutOfRange: `line` names vertex `index`, but there are `vertices`, counted from `first`.
[[noreturn]] void failIndex(const std::string& path, std::size_t line, std::int64_t index, std::size_t vertices, int first);

/// Throws kTooLarge if a file announces more triangles than allowed.
void checkTriangleCount(const std::string& path, std::uint64_t triangles, std::size_t most);

/// Throws kNotAMesh if a text is in UTF-16 or holds a zero byte. Returns the text without the byte order mark of UTF-8.
std::string_view checkedText(std::string_view bytes, const std::string& path);

/// The number that a word of line `line` spells; throws kNotAMesh if it spells none.
double numberIn(std::string_view word, const std::string& path, std::size_t line);

}  // namespace collision_hulls
