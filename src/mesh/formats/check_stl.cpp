// Checks an STL file before it is read. The size, not the first word, tells binary from text; a binary file must hold exactly the triangles
// it announces, and each facet of a text file exactly three vertices.
#include <algorithm>
#include <cstring>

#include "mesh/formats/scan.h"
#include "mesh/formats/source_checks.h"

namespace collision_hulls {
namespace {

std::uint64_t announcedTriangles(std::string_view bytes) {
  std::uint32_t count = 0;  // little-endian, like the machines this runs on
  std::memcpy(&count, bytes.data() + kStlHeaderBytes - sizeof count, sizeof count);
  return count;
}

/// Every facet must have three vertices: Assimp groups vertices by threes regardless of facets.
void checkText(std::string_view bytes, const std::string& path, std::size_t max_triangles) {
  std::string_view rest = bytes;
  std::size_t facets = 0;
  int vertices = 3;
  bool inside = false;
  for (std::string_view word = nextWord(&rest); !word.empty(); word = nextWord(&rest)) {
    if (word == "solid" || word == "endsolid") {
      inside = word == "solid";
      rest.remove_prefix(std::min(rest.find('\n'), rest.size()));  // a solid's name may hold any word
    } else if (word == "facet") {
      ++facets;
      vertices = 0;
    } else if (word == "vertex") {
      ++vertices;
    } else if (word == "endfacet" && vertices != 3) {
      failNotAMesh(path, "facet " + std::to_string(facets) + " has " + std::to_string(vertices) + " vertices instead of 3");
    }
  }
  if (inside) failNotAMesh(path, "text STL without 'endsolid' at its end, cut off after facet " + std::to_string(facets));
  checkTriangleCount(path, facets, max_triangles);
}

}  // namespace

bool isBinaryStl(std::string_view bytes) {
  return bytes.size() >= kStlHeaderBytes && bytes.size() == kStlHeaderBytes + kStlFacetBytes * announcedTriangles(bytes);
}

void checkStl(std::string_view bytes, const std::string& path, std::size_t max_triangles) {
  const std::uint64_t count = bytes.size() >= kStlHeaderBytes ? announcedTriangles(bytes) : 0;
  // The size decides: many binary files, too, begin with "solid".
  if (isBinaryStl(bytes)) {
    if (count == 0) throw Error(ErrorCode::kEmptyMesh, path + ": binary STL with 0 triangles; export the mesh again");
    checkTriangleCount(path, count, max_triangles);
    return;
  }
  std::string_view rest = bytes;
  if (nextWord(&rest) == "solid" && bytes.find('\0') == std::string_view::npos) {
    checkText(bytes, path, max_triangles);
  } else if (bytes.size() < kStlHeaderBytes) {
    failNotAMesh(path, "neither a text STL (no 'solid' at its start) nor a binary one (" + std::to_string(bytes.size()) +
                           " bytes, less than its header of " + std::to_string(kStlHeaderBytes) + ")");
  } else {
    failNotAMesh(path, "read as binary STL, it announces " + std::to_string(count) + " triangles, which take " +
                           std::to_string(kStlHeaderBytes + kStlFacetBytes * count) + " bytes, but it has " + std::to_string(bytes.size()));
  }
}

}  // namespace collision_hulls
