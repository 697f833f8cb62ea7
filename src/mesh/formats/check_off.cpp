// Checks an OFF file before Assimp reads it: Assimp allocates whatever the header announces, drops large faces, overruns a fixed line
// buffer and stops silently at the end of a truncated file.
#include <algorithm>

#include "mesh/formats/scan.h"
#include "mesh/formats/source_checks.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongestLine = 4000;  // Assimp's buffer holds 4096 characters and is written one beyond its end
constexpr std::int64_t kMostCorners = 9;    // Assimp drops larger faces

/// The next word outside comments; `rest` keeps what follows it.
std::string_view nextHeaderWord(std::string_view* rest) {
  while (true) {
    const std::string_view word = nextWord(rest);
    if (word.empty() || word[0] != '#') return word;
    rest->remove_prefix(std::min(rest->find_first_of("\n\r"), rest->size()));
  }
}

struct Counts {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

/// Takes the header off `rest`: an optional keyword that ends in OFF, and three numbers.
Counts readHeader(std::string_view* rest, const std::string& path) {
  std::string_view word = nextHeaderWord(rest);
  const bool keyword = word.size() >= 3 && word.substr(word.size() - 3) == "OFF";
  if (keyword) word = nextHeaderWord(rest);
  if (keyword && word == "BINARY") failNotAMesh(path, "binary OFF is not supported");
  Counts counts;
  std::int64_t edges = 0;
  if (!parseInteger(word, &counts.vertices) || !parseInteger(nextHeaderWord(rest), &counts.faces) ||
      !parseInteger(nextHeaderWord(rest), &edges) || counts.vertices < 0 || counts.faces < 0)
    failNotAMesh(path, "does not begin with 'OFF' and the numbers of vertices, faces and edges");
  return counts;
}

void checkFace(std::string_view line, std::size_t number, std::int64_t vertices, const std::string& path) {
  std::int64_t corners = 0;
  if (!parseInteger(nextWord(&line), &corners) || corners < 1 || corners > kMostCorners)
    failNotAMesh(path, number, "a face line begins with its number of corners, from 1 to " + std::to_string(kMostCorners));
  for (; corners > 0; --corners) {
    std::int64_t index = 0;
    if (!parseInteger(nextWord(&line), &index)) failNotAMesh(path, number, "a corner of the face is missing or not a number");
    if (index < 0 || index >= vertices)
      throw Error(ErrorCode::kIndexOutOfRange, path + ": line " + std::to_string(number) + " names vertex " + std::to_string(index) +
                                                   ", but there are " + std::to_string(vertices) + ", counted from 0; export it again");
  }
}

}  // namespace

Announced checkOff(std::string_view bytes, const std::string& path, std::size_t max_triangles) {
  checkIsText(bytes, path);
  std::string_view rest = bytes;
  const Counts counts = readHeader(&rest, path);
  if (counts.faces == 0 || counts.vertices == 0)
    throw Error(ErrorCode::kEmptyMesh, path + ": announces " + std::to_string(counts.vertices) + " vertices and " +
                                           std::to_string(counts.faces) + " faces; export the mesh again");
  checkTriangleCount(path, static_cast<std::uint64_t>(counts.faces), max_triangles);
  if (counts.vertices > static_cast<std::int64_t>(bytes.size()))  // each vertex takes a line
    failNotAMesh(path,
                 "announces " + std::to_string(counts.vertices) + " vertices but has only " + std::to_string(bytes.size()) + " bytes");
  const std::string_view header = bytes.substr(0, bytes.size() - rest.size());
  LineScanner lines(rest, 1 + static_cast<std::size_t>(std::count(header.begin(), header.end(), '\n')));
  std::string_view line;
  for (std::int64_t i = 0; i < counts.vertices + counts.faces; ++i) {
    if (!lines.next(&line))
      failNotAMesh(path, "announces " + std::to_string(counts.vertices) + " vertices and " + std::to_string(counts.faces) +
                             " faces, but ends after " + std::to_string(i) + " lines of them");
    if (line.size() > kLongestLine) failNotAMesh(path, lines.number(), "longer than " + std::to_string(kLongestLine) + " characters");
    if (i >= counts.vertices) checkFace(line, lines.number(), counts.vertices, path);
  }
  return {static_cast<std::size_t>(counts.vertices), static_cast<std::size_t>(counts.faces)};
}

}  // namespace collision_hulls
