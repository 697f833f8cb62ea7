// STL, binary or text. The size, not the first word, tells which: many binary files begin with "solid", too. A text that has the size of a
// binary file would have to be larger than 7 GB, because the four bytes of its count would be printable or blanks.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "mesh/formats/readers.h"
#include "mesh/formats/scan.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kStlHeaderBytes = 84;  // including the number of triangles
constexpr std::size_t kFacetBytes = 50;      // normal, three corners, two bytes
constexpr std::size_t kFacetsBetweenChecks = 1 << 16;

std::uint64_t announcedTriangles(std::string_view bytes) {
  std::uint32_t count = 0;  // little-endian, like the machines this runs on
  std::memcpy(&count, bytes.data() + kStlHeaderBytes - sizeof count, sizeof count);
  return count;
}

LoadedMesh readBinary(const std::string& bytes, const std::string& path, const RunControl& control) {
  LoadedMesh result;
  result.submeshes = 1;
  const std::size_t count = (bytes.size() - kStlHeaderBytes) / kFacetBytes;
  result.mesh.vertices.reserve(3 * count);
  result.mesh.triangles.reserve(count);
  float largest = 0;
  for (std::size_t f = 0; f < count; ++f) {
    if (f % kFacetsBetweenChecks == 0) control.check();
    std::array<float, 9> corners;  // they follow the normal
    std::memcpy(corners.data(), bytes.data() + kStlHeaderBytes + kFacetBytes * f + 3 * sizeof(float), sizeof corners);
    const int first = static_cast<int>(3 * f);
    result.mesh.triangles.push_back({first, first + 1, first + 2});
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      result.mesh.vertices.emplace_back(corners[k], corners[k + 1], corners[k + 2]);
      if (!result.mesh.vertices.back().allFinite()) failNotFinite(path, 3 * f + k / 3, f);
    }
    for (const float x : corners) largest = std::max(largest, std::abs(x));
  }
  result.resolution = singlePrecisionResolution(result.mesh, largest, path);
  return result;
}

/// Keywords are in lower case, but for some programs.
bool isKeyword(std::string_view word, std::string_view keyword) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; };
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), same);
}

class TextReader {
 public:
  TextReader(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control)
      : lines_(bytes, control), path_(path), polygons_(path, limits.max_triangles, control) {}

  LoadedMesh read() {
    while (!word().empty()) {
      expect("solid");
      line_ = {};  // a solid's name may hold any word
      polygons_.beginPart();
      while (isKeyword(word(), "facet")) readFacet();
      if (word_.empty()) failNotAMesh(path_, "text STL without 'endsolid' at its end, cut off after facet " + std::to_string(facets_));
      expect("endsolid");
      line_ = {};
    }
    return polygons_.triangles(Polygons::Vertices::kSeparate);
  }

 private:
  std::string_view word() {
    for (word_ = nextWord(&line_); word_.empty() && lines_.next(&line_);) word_ = nextWord(&line_);
    return word_;
  }

  void expect(std::string_view wanted) const {
    if (!isKeyword(word_, wanted))
      failNotAMesh(path_, lines_.number(),
                   "expected '" + std::string(wanted) + "', found " + (word_.empty() ? "the end" : inQuotes(word_)));
  }

  void readFacet() {
    ++facets_;
    word();
    expect("normal");
    for (int k = 0; k < 3; ++k) word();  // of no use: some programs write 'nan' for slivers
    for (const char* wanted : {"outer", "loop"}) {
      word();
      expect(wanted);
    }
    int corners = 0;
    for (; isKeyword(word(), "vertex"); ++corners) readCorner();
    expect("endloop");
    word();
    expect("endfacet");
    if (corners != 3)
      failNotAMesh(path_, lines_.number(),
                   "facet " + std::to_string(facets_) + " has " + std::to_string(corners) + " vertices instead of 3");
    polygons_.endPolygon();
  }

  void readCorner() {
    std::array<double, 3> p{};
    for (double& x : p) {
      word();
      x = numberIn(word_, path_, lines_.number());
    }
    polygons_.addCorner(static_cast<int>(polygons_.points()));
    polygons_.addPoint(p[0], p[1], p[2]);
  }

  LineScanner lines_;
  const std::string& path_;
  Polygons polygons_;
  std::string_view line_;  // what is left of the current line
  std::string_view word_;
  std::size_t facets_ = 0;
};

bool isText(std::string_view bytes) {
  return isKeyword(nextWord(&bytes), "solid") && bytes.find('\0') == std::string_view::npos;
}

}  // namespace

bool isBinaryStl(std::string_view bytes) {
  return bytes.size() >= kStlHeaderBytes && bytes.size() == kStlHeaderBytes + kFacetBytes * announcedTriangles(bytes);
}

LoadedMesh readStl(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control) {
  if (isBinaryStl(bytes)) {
    if (announcedTriangles(bytes) == 0) throw Error(ErrorCode::kEmptyMesh, path + ": binary STL with 0 triangles; export the mesh again");
    checkTriangleCount(path, announcedTriangles(bytes), std::min(limits.max_triangles, kMostTriangles));
    return readBinary(bytes, path, control);
  }
  if (isText(bytes)) return TextReader(bytes, path, limits, control).read();
  if (bytes.size() < kStlHeaderBytes)
    failNotAMesh(path, "neither a text STL (no 'solid' at its start) nor a binary one (" + std::to_string(bytes.size()) +
                           " bytes, less than its header of " + std::to_string(kStlHeaderBytes) + ")");
  const std::uint64_t count = announcedTriangles(bytes);
  failNotAMesh(path, "read as binary STL, it announces " + std::to_string(count) + " triangles, which take " +
                         std::to_string(kStlHeaderBytes + kFacetBytes * count) + " bytes, but it has " + std::to_string(bytes.size()));
}

}  // namespace collision_hulls
