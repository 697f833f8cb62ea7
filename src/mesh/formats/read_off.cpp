// OFF, line by line: a header with the numbers of vertices and faces, then a line for each. What a variant adds to a line (normals,
// colours, texture coordinates) follows the coordinates and is skipped.
#include <array>

#include "mesh/formats/number.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/scan.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

/// Whether the first line announces binary data.
bool isBinary(std::string_view bytes) {
  std::string_view line = bytes.substr(0, bytes.find('\n'));
  const std::string_view keyword = nextWord(&line);
  return keyword.size() >= 3 && keyword.substr(keyword.size() - 3) == "OFF" && nextWord(&line) == "BINARY";
}

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& path, const MeshLimits& limits, const RunControl& control)
      : text_(text), lines_(text, control), path_(path), most_triangles_(limits.max_triangles), polygons_(path, most_triangles_, control) {}

  LoadedMesh read() {
    readHeader();
    for (std::int64_t i = 0; i < vertices_; ++i) readVertex(line(i));
    for (std::int64_t i = 0; i < faces_; ++i) readFace(line(vertices_ + i));
    if (nextLine()) failNotAMesh(path_, lines_.number(), "more than the " + std::to_string(faces_) + " faces that are announced");
    return polygons_.triangles(Polygons::Vertices::kShared);
  }

 private:
  /// Moves to the next line with something outside its comment.
  bool nextLine() {
    for (std::string_view raw; lines_.next(&raw);) {
      line_ = withoutComment(raw);
      std::string_view rest = line_;
      if (!nextWord(&rest).empty()) return true;
    }
    return false;
  }

  /// Line `i` of the data.
  std::string_view line(std::int64_t i) {
    if (!nextLine())
      failNotAMesh(path_, "announces " + std::to_string(vertices_) + " vertices and " + std::to_string(faces_) + " faces, but ends after " +
                              std::to_string(i) + " lines of them");
    return line_;
  }

  /// An optional keyword, then the numbers of vertices, faces and edges. Programs leave out the last, and the space behind the keyword (as
  /// in many files of ModelNet).
  void readHeader() {
    if (!nextLine()) failHeader();
    std::string_view rest = line_;
    std::string_view word = nextWord(&rest);
    if (word.size() >= 3 && word.substr(word.size() - 3) == "OFF") {
      checkVariant(word.substr(0, word.size() - 3));
      word = nextWord(&rest);
      if (word.empty() && nextLine()) {
        rest = line_;
        word = nextWord(&rest);
      }
    } else if (word.substr(0, 3) == "OFF") {
      word.remove_prefix(3);
    }
    std::int64_t edges = 0;
    if (!parseInteger(word, &vertices_) || !parseInteger(nextWord(&rest), &faces_) || vertices_ < 0 || faces_ < 0) failHeader();
    word = nextWord(&rest);
    if ((!word.empty() && !parseInteger(word, &edges)) || !nextWord(&rest).empty()) failHeader();
    checkCounts();
  }

  /// Letters before OFF: ST texture coordinates, C colours, N normals.
  void checkVariant(std::string_view letters) const {
    for (const std::string_view known : {"ST", "C", "N"})
      if (letters.substr(0, known.size()) == known) letters.remove_prefix(known.size());
    if (!letters.empty())
      failNotAMesh(path_, lines_.number(), "the variant " + inQuotes(std::string(letters) + "OFF") + " is not supported",
                   "write it as OFF");
  }

  void checkCounts() {
    if (faces_ == 0 || vertices_ == 0)
      throw Error(ErrorCode::kEmptyMesh, path_ + ": announces " + std::to_string(vertices_) + " vertices and " + std::to_string(faces_) +
                                             " faces; export the mesh again");
    checkTriangleCount(path_, static_cast<std::uint64_t>(faces_), most_triangles_);
    const auto size = static_cast<std::int64_t>(text_.size());
    if (vertices_ > size || faces_ > size)  // each takes a line
      failNotAMesh(path_, "announces " + std::to_string(vertices_) + " vertices and " + std::to_string(faces_) + " faces but has only " +
                              std::to_string(size) + " bytes");
    polygons_.reserve(static_cast<std::size_t>(vertices_), static_cast<std::size_t>(faces_));
  }

  [[noreturn]] void failHeader() const { failNotAMesh(path_, "does not begin with 'OFF' and the numbers of vertices, faces and edges"); }

  void readVertex(std::string_view line) {
    std::array<double, 3> p{};
    for (double& x : p) x = numberIn(nextWord(&line), path_, lines_.number());
    checkRest(line);
    polygons_.addPoint(p[0], p[1], p[2]);
  }

  void readFace(std::string_view line) {
    std::int64_t corners = 0;
    const std::string_view first = nextWord(&line);
    if (!parseInteger(first, &corners) || corners < 1)
      failNotAMesh(path_, lines_.number(), "a face begins with its number of corners, not with " + inQuotes(first));
    for (; corners > 0; --corners) {
      std::int64_t index = 0;
      const std::string_view word = nextWord(&line);
      if (!parseInteger(word, &index))
        failNotAMesh(path_, lines_.number(),
                     word.empty() ? "the face has fewer corners than announced" : inQuotes(word) + " is not an index");
      if (index < 0 || index >= vertices_) failIndex(path_, lines_.number(), index, static_cast<std::size_t>(vertices_), 0);
      polygons_.addCorner(static_cast<int>(index));
    }
    polygons_.endPolygon();
    checkRest(line);
  }

  /// What follows, a colour for example, must be numbers.
  void checkRest(std::string_view line) const {
    for (std::string_view word = nextWord(&line); !word.empty(); word = nextWord(&line)) numberIn(word, path_, lines_.number());
  }

  std::string_view text_;
  LineScanner lines_;
  const std::string& path_;
  std::size_t most_triangles_;
  Polygons polygons_;
  std::string_view line_;
  std::int64_t vertices_ = 0;
  std::int64_t faces_ = 0;
};

}  // namespace

LoadedMesh readOff(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control) {
  if (isBinary(bytes)) failNotAMesh(path, "binary OFF is not supported", "write it as text");
  return OffReader(checkedText(bytes, path), path, limits, control).read();
}

}  // namespace collision_hulls
