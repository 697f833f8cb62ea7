#include "collision_hulls/check/solid.h"

#include <utility>

#include "collision_hulls/geometry/triangle_bvh.h"

namespace collision_hulls {

namespace {

/// The triangles of the components that have an inside.
TriangleMesh enclosing(const RepairedMesh& mesh) {
  TriangleMesh result;
  result.vertices = mesh.mesh.vertices;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    if (mesh.interior[static_cast<std::size_t>(mesh.component[t])] != Interior::kSurface)
      result.triangles.push_back(mesh.mesh.triangles[t]);
  return result;
}

/// Loose points as triangles of no area, so that they count as surface.
TriangleMesh withLoosePoints(const RepairedMesh& mesh) {
  TriangleMesh result = mesh.mesh;
  for (const Eigen::Vector3d& p : mesh.loose) {
    const int i = static_cast<int>(result.vertices.size());
    result.vertices.push_back(p);
    result.triangles.push_back({i, i, i});
  }
  return result;
}

}  // namespace

struct Solid::Impl {
  explicit Impl(const RepairedMesh& mesh)
      : surface(withLoosePoints(mesh)), walls(enclosing(mesh)), interior(interiorOf(mesh)), volume(signedVolume(enclosing(mesh))) {}
  TriangleBvh surface, walls;
  Interior interior;
  double volume;
};

Solid::Solid(const RepairedMesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
Solid::~Solid() = default;
Solid::Solid(Solid&&) noexcept = default;

bool Solid::contains(const Eigen::Vector3d& p) const {
  return !impl_->walls.empty() && impl_->walls.windingNumber(p) > 0.5;
}
double Solid::distanceToSurface(const Eigen::Vector3d& p) const {
  return impl_->surface.nearest(p).distance;
}
double Solid::distance(const Eigen::Vector3d& p) const {
  return contains(p) ? 0 : distanceToSurface(p);
}
double Solid::volume() const {
  return impl_->volume;
}
Interior Solid::interior() const {
  return impl_->interior;
}
const TriangleBvh& Solid::surface() const {
  return impl_->surface;
}

}  // namespace collision_hulls
