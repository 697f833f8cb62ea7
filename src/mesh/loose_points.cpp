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

}  // namespace collision_hulls
