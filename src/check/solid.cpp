#include "collision_hulls/check/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "mesh/edges.h"

namespace collision_hulls {

namespace {

/// The triangles of the components of one kind.
TriangleMesh componentsOf(const RepairedMesh& mesh, Interior kind) {
  TriangleMesh result;
  result.vertices = mesh.mesh.vertices;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    if (mesh.interior[static_cast<std::size_t>(mesh.component[t])] == kind) result.triangles.push_back(mesh.mesh.triangles[t]);
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

// How many triangles' outer sides are looked at for a winding number below zero.
constexpr std::size_t kMostProbes = 2000;
constexpr double kProbeStep = 1e-3;  // off the triangle, in lengths of its shortest altitude or so

/// What lies inside, by the components that have an inside.
struct Walls {
  explicit Walls(const RepairedMesh& mesh) : Walls(componentsOf(mesh, Interior::kClosed), componentsOf(mesh, Interior::kWinding)) {}
  Walls(const TriangleMesh& closed_mesh, const TriangleMesh& open_mesh)
      : closed(closed_mesh),
        open(open_mesh),
        volume(signedVolume(closed_mesh) + signedVolume(open_mesh)),
        inverted(hasInvertedRegion(closed_mesh) || hasInvertedRegion(open_mesh)) {}

  double windingNumber(const Eigen::Vector3d& p) const { return closed.signedCrossings(p) + (open.empty() ? 0 : open.windingNumber(p)); }

  /// Whether some region is enclosed inside out: then a triangle's back may face the outside.
  bool hasInvertedRegion(const TriangleMesh& walls) const {
    const std::size_t n = walls.triangles.size(), stride = std::max<std::size_t>(1, n / kMostProbes);
    for (std::size_t t = 0; t < n; t += stride) {
      const int i = static_cast<int>(t);
      const Eigen::Vector3d &a = walls.corner(i, 0), &b = walls.corner(i, 1), &c = walls.corner(i, 2);
      const Eigen::Vector3d normal = (b - a).cross(c - a);
      if (!(normal.norm() > 0)) continue;
      const Eigen::Vector3d probe = (a + b + c) / 3 + normal.normalized() * (kProbeStep * std::sqrt(normal.norm()));
      if (windingNumber(probe) < -0.5) return true;
    }
    return false;
  }

  TriangleBvh closed, open;
  double volume;
  bool inverted;
};

/// Per triangle of withLoosePoints(): whether both of its sides may face the outside.
std::vector<char> twoSided(const RepairedMesh& mesh, bool all) {
  const std::vector<Triangle>& triangles = mesh.mesh.triangles;
  std::vector<char> result(triangles.size() + mesh.loose.size(), 1);
  if (all) return result;
  const Edges edges = findEdges(triangles, mesh.mesh.vertices.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    bool sheet = mesh.interior[static_cast<std::size_t>(mesh.component[t])] == Interior::kSurface;
    for (int h = static_cast<int>(3 * t); h < static_cast<int>(3 * t) + 3; ++h) {
      const int twin = edges.twin[static_cast<std::size_t>(h)];
      sheet = sheet || twin == Edges::kOpen || (twin >= 0 && startOf(triangles, twin) != endOf(triangles, h));
    }
    result[t] = sheet;
  }
  return result;
}

}  // namespace

struct Solid::Impl {
  explicit Impl(const RepairedMesh& mesh)
      : walls(mesh), surface(withLoosePoints(mesh), twoSided(mesh, walls.inverted)), interior(interiorOf(mesh)) {}
  Walls walls;
  TriangleBvh surface;
  Interior interior;
};

Solid::Solid(const RepairedMesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
Solid::~Solid() = default;
Solid::Solid(Solid&&) noexcept = default;

bool Solid::contains(const Eigen::Vector3d& p) const {
  return impl_->walls.windingNumber(p) > 0.5;
}
double Solid::distanceToSurface(const Eigen::Vector3d& p) const {
  return impl_->surface.nearest(p).distance;
}
double Solid::distance(const Eigen::Vector3d& p) const {
  return contains(p) ? 0 : distanceToSurface(p);
}
double Solid::volume() const {
  return impl_->walls.volume;
}
Interior Solid::interior() const {
  return impl_->interior;
}
bool Solid::withoutSummit(const Eigen::Vector3d& p, double radius) const {
  return impl_->surface.facesOneWay(p, distanceToSurface(p) + 2 * radius);
}
const TriangleBvh& Solid::surface() const {
  return impl_->surface;
}

}  // namespace collision_hulls
