// Sums over a mesh's triangles, and copies of a mesh scaled or moved.
#include "collision_hulls/geometry/triangle_mesh.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/decimal.h"
#include "base/looks.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

void check(const TriangleMesh& mesh, const RunControl& control) {
  Looks look(control);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    look();
    for (const int v : mesh.triangles[t]) {
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.vertices.size())
        throw Error(ErrorCode::kIndexOutOfRange, "triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                                                     ", but the mesh has " + std::to_string(mesh.vertices.size()) +
                                                     " vertices, counted from 0; correct or remove it");
      const Eigen::Vector3d& p = mesh.vertices[static_cast<std::size_t>(v)];
      if (!p.allFinite()) {
        const double wrong = !std::isfinite(p.x()) ? p.x() : !std::isfinite(p.y()) ? p.y() : p.z();
        throw Error(ErrorCode::kNonFiniteCoordinate, "vertex " + std::to_string(v) + " has the coordinate " + decimal(wrong) +
                                                         ", which is not a finite number; correct or remove it");
      }
    }
  }
}

Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : mesh.triangles)
    for (int i : t) box.extend(mesh.vertices[static_cast<std::size_t>(i)]);
  return box;
}

double diagonal(const TriangleMesh& mesh) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d& a = mesh.corner(t, 0);
    sum += (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm() / 2;
  }
  return sum;
}

double signedVolume(const TriangleMesh& mesh) {
  return signedVolume(mesh.vertices, mesh.triangles);
}

double signedVolume(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return 0;
  const auto at = [&](int v) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(v)]; };
  // About a corner of the mesh rather than the origin: far from the origin the tetrahedra would cancel badly.
  const Eigen::Vector3d apex = at(triangles[0][0]);
  double sum = 0;
  for (const Triangle& t : triangles) sum += (at(t[0]) - apex).dot((at(t[1]) - apex).cross(at(t[2]) - apex)) / 6;
  return sum;
}

TriangleMesh scaled(TriangleMesh mesh, const Eigen::Vector3d& scale) {
  if (!scale.allFinite() || (scale.array() == 0).any())
    throw Error(ErrorCode::kBadScale, "the mesh's scale is '" + decimal(scale.x()) + " " + decimal(scale.y()) + " " + decimal(scale.z()) +
                                          "'; give three finite numbers other than 0, such as '1 1 1'");
  for (Eigen::Vector3d& v : mesh.vertices) v = v.cwiseProduct(scale);
  if (scale.prod() < 0)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh transformed(TriangleMesh mesh, const Eigen::Isometry3d& pose) {
  for (Eigen::Vector3d& v : mesh.vertices) v = pose * v;
  return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const Triangle& t : more.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace collision_hulls
