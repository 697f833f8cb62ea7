// Loose segments as degenerate triangles; the distance queries accept those.
#include "mesh/loose_segments.h"

namespace collision_hulls {

void addSegment(TriangleMesh& mesh, const Segment& segment) {
  const int a = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(segment[0]);
  if (segment[1] != segment[0]) mesh.vertices.push_back(segment[1]);
  const int b = static_cast<int>(mesh.vertices.size()) - 1;
  mesh.triangles.push_back({a, b, b});
}

TriangleMesh withLoose(const RepairedMesh& mesh) {
  TriangleMesh surface = mesh.mesh;
  for (const Segment& segment : mesh.loose) addSegment(surface, segment);
  return surface;
}

Eigen::AlignedBox3d boundingBox(const RepairedMesh& mesh) {
  Eigen::AlignedBox3d box = boundingBox(mesh.mesh);
  for (const Segment& segment : mesh.loose) box.extend(segment[0]).extend(segment[1]);
  return box;
}

std::vector<Eigen::Vector3d> pointsOfComponents(const RepairedMesh& mesh) {
  std::vector<Eigen::Vector3d> points;
  for (const Segment& segment : mesh.loose) points.push_back(segment[0]);
  int seen = 0;
  for (std::size_t t = 0; t < mesh.component.size(); ++t) {
    if (mesh.component[t] < seen) continue;
    points.push_back(mesh.mesh.corner(static_cast<int>(t), 0));
    ++seen;
  }
  return points;
}

}  // namespace collision_hulls
