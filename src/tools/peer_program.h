// Shared by the small programs that wrap another library's decomposition: PROGRAM in.obj out.obj tolerance.
#pragma once

#include <string.h>

#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "base/decimal.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/mesh/repair.h"
#include "mesh/formats/number.h"
#include "storage/files.h"

namespace collision_hulls {

/// Decomposes a welded mesh at a tolerance [m] into surfaces, one per convex part.
using PeerDecompose = std::function<std::vector<TriangleMesh>(const TriangleMesh& mesh, double tolerance)>;

/// OBJ with one object per part; a part without triangles gets one face of all its points, so that it is not lost.
inline std::string toObj(const std::vector<TriangleMesh>& parts) {
  std::ostringstream text = decimalStream(9);
  std::size_t first = 1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text << "o part_" << i << '\n';
    std::string all = "f";
    for (std::size_t v = 0; v < parts[i].vertices.size(); ++v) {
      const Eigen::Vector3d& p = parts[i].vertices[v];
      text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      all += " " + std::to_string(first + v);
    }
    for (const Triangle& t : parts[i].triangles) {
      text << 'f';
      for (const int corner : t) text << ' ' << first + static_cast<std::size_t>(corner);
      text << '\n';
    }
    if (parts[i].triangles.empty() && !parts[i].vertices.empty()) text << all << '\n';
    first += parts[i].vertices.size();
  }
  return text.str();
}

/// The program's main. Exit status: 0 done, 1 no result, 2 usage error or unreadable input.
inline int peerMain(int argc, char** argv, const char* help, const PeerDecompose& decompose) try {
  argv[0] = basename(argv[0]);  // messages end up in tables, where folders do not belong
  if (argc == 2 && std::string(argv[1]) == "--help") {
    std::printf("usage: %s in.obj out.obj tolerance\n\n%s", argv[0], help);
    return 0;
  }
  double tolerance = 0;
  if (argc != 4 || !parseNumber(argv[3], &tolerance) || !(tolerance > 0)) {
    std::fprintf(stderr, "usage: %s in.obj out.obj tolerance; the tolerance is a positive length in metres\n", argv[0]);
    return 2;
  }
  const std::vector<TriangleMesh> parts = decompose(repair(readMesh(argv[1]).mesh).mesh, tolerance);
  if (parts.empty()) {
    std::fprintf(stderr, "%s: the library returned no hull\n", argv[0]);
    return 1;
  }
  writeText(argv[2], toObj(parts));
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
  return 2;
}

}  // namespace collision_hulls
