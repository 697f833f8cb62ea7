// Encodes a mesh in coloured parts as binary PLY. Colours are those of vertices, which all viewers show; vertices on the border of parts
// are therefore written for each of them.
#include <cstring>
#include <string>
#include <vector>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {
namespace {

template <typename Number>
void append(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

/// Vertices and faces, as far as they are written.
struct Body {
  std::string vertices, faces;
  std::int32_t vertex_count = 0, face_count = 0;

  void add(const Eigen::Vector3d& v, const Rgb& colour) {
    for (const double x : {v.x(), v.y(), v.z()}) append(vertices, static_cast<float>(x));
    for (const std::uint8_t channel : colour) append(vertices, channel);
    ++vertex_count;
  }
};

void checkParts(const TriangleMesh& mesh, const std::vector<std::vector<int>>& parts, const std::vector<Rgb>& colours) {
  check(mesh);
  const auto refuse = [](const std::string& text) { throw Error(ErrorCode::kIndexOutOfRange, text); };
  if (colours.size() < parts.size())
    refuse("a mesh of " + std::to_string(parts.size()) + " parts has " + std::to_string(colours.size()) + " colours; give one for each");
  for (const std::vector<int>& part : parts)
    for (const int t : part)
      if (t < 0 || static_cast<std::size_t>(t) >= mesh.triangles.size())
        refuse("a part names triangle " + std::to_string(t) + ", but the mesh has " + std::to_string(mesh.triangles.size()) +
               ", counted from 0; correct the part");
}

}  // namespace

std::string encodePly(const TriangleMesh& mesh, const std::vector<std::vector<int>>& parts, const std::vector<Rgb>& colours) {
  checkParts(mesh, parts, colours);
  Body body;
  std::vector<std::int32_t> place(mesh.vertices.size()), used_by(mesh.vertices.size(), -1);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto part = static_cast<std::int32_t>(k);
    for (const int t : parts[k]) {
      append(body.faces, std::uint8_t{3});
      for (const int corner : mesh.triangles[static_cast<std::size_t>(t)]) {
        const auto v = static_cast<std::size_t>(corner);
        if (used_by[v] != part) {
          used_by[v] = part;
          place[v] = body.vertex_count;
          body.add(mesh.vertices[v], colours[k]);
        }
        append(body.faces, place[v]);
      }
      append(body.faces, part);
      ++body.face_count;
    }
  }
  return "ply\nformat binary_little_endian 1.0\ncomment metres, written by collision_hulls\nelement vertex " +
         std::to_string(body.vertex_count) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
         "element face " +
         std::to_string(body.face_count) + "\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n" + body.vertices +
         body.faces;
}

}  // namespace collision_hulls
