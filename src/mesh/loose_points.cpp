#include "mesh/loose_points.h"

namespace collision_hulls {

void addPoint(TriangleMesh& mesh, const Eigen::Vector3d& p) {
  const int i = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(p);
  mesh.triangles.push_back({i, i, i});
}

TriangleMesh withLoosePoints(const RepairedMesh& mesh) {
  TriangleMesh surface = mesh.mesh;
  for (const Eigen::Vector3d& p : mesh.loose) addPoint(surface, p);
  return surface;
}

std::vector<Eigen::Vector3d> pointsOfComponents(const RepairedMesh& mesh) {
  std::vector<Eigen::Vector3d> points = mesh.loose;
  int seen = 0;
  for (std::size_t t = 0; t < mesh.component.size(); ++t) {
    if (mesh.component[t] < seen) continue;
    points.push_back(mesh.mesh.corner(static_cast<int>(t), 0));
    ++seen;
  }
  return points;
}

}  // namespace collision_hulls
