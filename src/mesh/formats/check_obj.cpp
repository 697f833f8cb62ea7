// Checks an OBJ file before Assimp reads it: Assimp skips vertices it does not understand, which shifts every later index, and clamps or
// drops indices that are out of range. One pass over the lines.
#include <algorithm>

#include "mesh/formats/scan.h"
#include "mesh/formats/source_checks.h"

namespace collision_hulls {
namespace {

class ObjCheck {
 public:
  ObjCheck(std::string_view bytes, const std::string& path) : lines_(bytes), path_(path) {}

  void run() {
    for (std::string_view line; nextRecord(&line);) {
      const std::string_view keyword = nextWord(&line);
      if (keyword == "v") checkVertex(line);
      if (keyword == "f" || keyword == "l" || keyword == "p") checkCorners(line);
      known_ = known_ || isKnown(keyword);
    }
    if (vertices_ == 0 && !known_) failNotAMesh(path_, "none of its lines belongs in an OBJ file");
    if (largest_index_ > vertices_) failIndex(largest_line_, largest_index_);
  }

 private:
  static bool isKnown(std::string_view keyword) {
    constexpr std::string_view kKeywords[] = {"v", "vt", "vn", "vp", "f", "l", "p", "o", "g", "s", "usemtl", "mtllib"};
    return keyword[0] == '#' || std::find(std::begin(kKeywords), std::end(kKeywords), keyword) != std::end(kKeywords);
  }

  /// The next line, joined with its continuation lines (each announced by a trailing backslash).
  bool nextRecord(std::string_view* record) {
    if (!lines_.next(record)) return false;
    if (record->back() != '\\') return true;
    joined_.assign(*record);
    std::string_view more;
    while (joined_.back() == '\\') {
      joined_.pop_back();
      if (!lines_.next(&more)) failNotAMesh(path_, lines_.number(), "a backslash at the end of the last line");
      joined_ += more;
    }
    *record = joined_;
    return true;
  }

  /// Assimp skips a vertex with any other number of values, which shifts the indices of all that follow.
  void checkVertex(std::string_view line) {
    int numbers = 0;
    for (std::string_view word = nextWord(&line); !word.empty() && word[0] != '#'; word = nextWord(&line)) numbers += startsNumber(word);
    if (numbers != 3 && numbers != 4 && numbers != 6)
      failNotAMesh(path_, lines_.number(),
                   "a vertex of " + std::to_string(numbers) +
                       " numbers; it needs 3, 4 (with w) or 6 (with a colour), each "
                       "starting with a digit or a sign");
    ++vertices_;
  }

  static bool startsNumber(std::string_view word) {
    const char c = word[0];
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == 'n' || c == 'N' || c == 'i' || c == 'I';
  }

  /// Corners "v", "v/vt", "v//vn" or "v/vt/vn"; v counts from 1, or, if negative, back from the latest vertex.
  void checkCorners(std::string_view line) {
    for (std::string_view word = nextWord(&line); !word.empty(); word = nextWord(&line)) {
      std::int64_t index = 0;
      if (!parseInteger(word.substr(0, word.find('/')), &index) || word.find_first_not_of("-/0123456789") != std::string_view::npos)
        failNotAMesh(path_, lines_.number(), "'" + std::string(word.substr(0, 40)) + "' is not a corner of a face");
      if (index == 0 || index < -vertices_) failIndex(lines_.number(), index);
      if (index <= largest_index_) continue;
      largest_index_ = index;
      largest_line_ = lines_.number();
    }
  }

  [[noreturn]] void failIndex(std::size_t line, std::int64_t index) const {
    throw Error(ErrorCode::kIndexOutOfRange, path_ + ": line " + std::to_string(line) + " names vertex " + std::to_string(index) +
                                                 ", but there are " + std::to_string(vertices_) + ", counted from 1; export it again");
  }

  LineScanner lines_;
  const std::string& path_;
  std::string joined_;
  bool known_ = false;
  std::int64_t vertices_ = 0;
  std::int64_t largest_index_ = 0;
  std::size_t largest_line_ = 0;
};

}  // namespace

void checkObj(std::string_view bytes, const std::string& path) {
  checkIsText(bytes, path);
  ObjCheck(bytes, path).run();
}

}  // namespace collision_hulls
