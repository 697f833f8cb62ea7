// What the formats have in common: rotations are checked before they are normalized, and a mesh that many bodies use is read once.
#include "scene/reading.h"

#include <cmath>

#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

void failConfigurations(const std::string& where, const std::string& reason) {
  throw Error(ErrorCode::kBadConfigurations, where + ": " + reason);
}

Eigen::Quaterniond checkedQuaternion(double x, double y, double z, double w) {
  constexpr double kRounded = 1e-2;  // allows for decimal text with few digits
  const Eigen::Quaterniond q(w, x, y, z);
  if (!(std::abs(q.norm() - 1) <= kRounded)) {
    throw Error(ErrorCode::kBadScene, "a quaternion of length " + decimal(q.norm()) + "; a rotation needs length 1");
  }
  return q.normalized();
}

TriangleMesh MeshLibrary::read(const std::string& uri, const Eigen::Vector3d& scale, const std::string& base) {
  const std::string path = resolveUri(uri, base, how_.find_package);
  const auto found = by_path_.find(path);
  const TriangleMesh& mesh =
      found != by_path_.end() ? found->second : by_path_.emplace(path, readMesh(path, how_.limits, how_.control).mesh).first->second;
  count(mesh.triangles.size(), path);
  return scaled(mesh, scale);
}

void MeshLibrary::count(std::size_t triangles, const std::string& path) {
  triangles_ += triangles;
  if (isFull())
    throw Error(ErrorCode::kTooLarge, "the meshes of " + whose_ + " have more than " + std::to_string(how_.limits.max_triangles) +
                                          " triangles in all, one that is used twice counted twice; simplify '" + path + "'");
}

std::vector<std::string> MeshLibrary::files() const {
  std::vector<std::string> files;
  for (const auto& [path, mesh] : by_path_) files.push_back(path);
  return files;
}

}  // namespace collision_hulls
