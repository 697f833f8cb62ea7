// OBJ, one statement a line: vertices and polygons. What cannot carry surface is skipped, free-form surfaces and anything unknown are
// refused.
#include <algorithm>
#include <array>
#include <limits>

#include "base/decimal.h"
#include "mesh/formats/number.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/scan.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

/// Statements that carry no surface.
constexpr std::string_view kSkipped[] = {"vt",     "vn",    "vp",       "s",        "mg",  "mtllib",     "usemap",
                                         "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj"};
constexpr std::string_view kBeginPart[] = {"g", "o", "usemtl"};
constexpr std::string_view kFreeForm[] = {"cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim",  "hole", "scrv",
                                          "sp",     "end", "con",  "bzp",  "bsp",  "cdc",   "cdp",  "res",  "ctech", "stech"};

template <std::size_t N>
bool isOneOf(const std::string_view (&words)[N], std::string_view word) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& path, const MeshLimits& limits, const RunControl& control)
      : lines_(text, control), path_(path), polygons_(path, limits.max_triangles, control) {}

  LoadedMesh read() {
    for (std::string_view statement; nextStatement(&statement);) readStatement(statement);
    if (largest_index_ > points()) failIndex(path_, largest_line_, largest_index_, polygons_.points(), 1);
    return polygons_.triangles(Polygons::Vertices::kSeparate);
  }

 private:
  /// The next line, joined with its continuation lines (each announced by a backslash at the end).
  bool nextStatement(std::string_view* statement) {
    if (!lines_.next(statement)) return false;
    line_ = lines_.number();
    if (statement->back() != '\\') return true;
    if (statement->find('#') != std::string_view::npos)
      failNotAMesh(path_, line_, "a comment that ends with a backslash: programs differ on whether it goes on", "remove the backslash");
    joined_.assign(*statement);
    for (std::string_view more; joined_.back() == '\\'; joined_ += more) {
      joined_.back() = ' ';
      const std::size_t last = lines_.number();
      if (!lines_.next(&more) || lines_.number() != last + 1)
        failNotAMesh(path_, last, "a backslash at the end, but nothing on the next line", "remove it");
    }
    *statement = joined_;
    return true;
  }

  void readStatement(std::string_view line) {
    const std::string_view keyword = nextWord(&line);
    if (keyword == "v") return readVertex(withoutComment(line));
    if (keyword == "f" || keyword == "fo") return readFace(withoutComment(line));
    if (keyword == "l" || keyword == "p") return skipPrimitives(keyword, withoutComment(line));
    if (isOneOf(kBeginPart, keyword)) return polygons_.beginPart();
    if (keyword[0] != '#' && !isOneOf(kSkipped, keyword)) failUnknown(keyword);
  }

  [[noreturn]] void failUnknown(std::string_view keyword) const {
    if (isOneOf(kFreeForm, keyword))
      failNotAMesh(path_, line_, inQuotes(keyword) + " belongs to a free-form curve or surface, which is not read",
                   "convert it to polygons");
    if (keyword == "call" || keyword == "csh")
      failNotAMesh(path_, line_, inQuotes(keyword) + " is not carried out", "put all of the mesh into this file");
    failNotAMesh(path_, line_, inQuotes(keyword) + " begins no statement of an OBJ file",
                 "check the file, or remove the line if it is a comment");
  }

  /// x y z, with a weight of 1 or with a colour. Programs differ on other weights: some divide by them, some ignore them.
  void readVertex(std::string_view line) {
    std::array<double, 6> numbers{};
    std::size_t count = 0;
    for (std::string_view word = nextWord(&line); !word.empty(); word = nextWord(&line), ++count)
      if (count < numbers.size()) numbers[count] = numberIn(word, path_, line_);
    if (count != 3 && count != 4 && count != 6)
      failNotAMesh(path_, line_, "a vertex of " + std::to_string(count) + " numbers; it needs 3, 4 (with w) or 6 (with a colour)");
    if (count == 4 && numbers[3] != 1)
      failNotAMesh(path_, line_, "a vertex with w = " + fixedDecimal(numbers[3]) + ", by which some programs divide and others do not",
                   "write the coordinates alone");
    polygons_.addPoint(numbers[0], numbers[1], numbers[2]);
  }

  void readFace(std::string_view line) {
    for (std::string_view word = nextWord(&line); !word.empty(); word = nextWord(&line)) polygons_.addCorner(cornerIn(word));
    polygons_.endPolygon();
  }

  /// Lines have a segment between each two of their corners; points stand by themselves.
  void skipPrimitives(std::string_view keyword, std::string_view line) {
    std::size_t corners = 0;
    for (std::string_view word = nextWord(&line); !word.empty(); word = nextWord(&line), ++corners) cornerIn(word);
    polygons_.skip(keyword == "p" || corners == 0 ? corners : corners - 1);
  }

  /// The point of a corner "v", "v/vt", "v//vn" or "v/vt/vn"; v counts from 1, or, if negative, back from the latest vertex.
  int cornerIn(std::string_view word) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    std::int64_t index = 0;
    if (!parseInteger(word.substr(0, slash), &index) || !isTail(word.substr(slash)))
      failNotAMesh(path_, line_, inQuotes(word) + " is not a corner of a face");
    if (index == 0 || index < -points() || index > std::numeric_limits<int>::max()) failIndex(path_, line_, index, polygons_.points(), 1);
    if (index < 0) return static_cast<int>(points() + index);
    if (index > largest_index_) {
      largest_index_ = index;
      largest_line_ = line_;
    }
    return static_cast<int>(index - 1);
  }

  /// Whether a corner goes on with at most two indices, which may be left out.
  static bool isTail(std::string_view tail) {
    for (int part = 0; part < 2 && !tail.empty(); ++part) {
      const std::size_t next = std::min(tail.find('/', 1), tail.size());
      std::int64_t index = 0;
      if (next > 1 && !parseInteger(tail.substr(1, next - 1), &index)) return false;
      tail.remove_prefix(next);
    }
    return tail.empty();
  }

  std::int64_t points() const { return static_cast<std::int64_t>(polygons_.points()); }

  LineScanner lines_;
  const std::string& path_;
  Polygons polygons_;
  std::string joined_;
  std::size_t line_ = 0;  // the number of the statement's first line
  std::int64_t largest_index_ = 0;
  std::size_t largest_line_ = 0;
};

}  // namespace

LoadedMesh readObj(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control) {
  std::string_view text = checkedText(bytes, path);
  if (text.size() < bytes.size() && nextWord(&text).substr(0, 1) != "#")
    failNotAMesh(path, "begins with a byte order mark, by which some readers lose the first line", "save it as UTF-8 without");
  return ObjReader(checkedText(bytes, path), path, limits, control).read();
}

}  // namespace collision_hulls
