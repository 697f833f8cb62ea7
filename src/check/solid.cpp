#include "collision_hulls/check/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "mesh/edges.h"

namespace collision_hulls {

namespace {

/// The boundary of the oriented surface: edges whose triangles do not run along them equally often in both directions.
struct Rim {
  std::vector<std::array<int, 2>> edges;  // as often as one direction prevails
  std::vector<char> has_some;             // per component
};

Rim rimOf(const RepairedMesh& mesh) {
  const std::vector<Triangle>& triangles = mesh.mesh.triangles;
  const Edges all = findEdges(triangles, mesh.mesh.vertices.size());
  std::map<std::array<int, 2>, std::pair<int, int>> surplus;  // and the component
  for (int h = 0; h < static_cast<int>(all.twin.size()); ++h) {
    const int from = startOf(triangles, h), to = endOf(triangles, h), twin = all.twin[static_cast<std::size_t>(h)];
    if (twin >= 0 && startOf(triangles, twin) == to) continue;
    auto& [count, component] = surplus[{std::min(from, to), std::max(from, to)}];
    count += from < to ? 1 : -1;
    component = mesh.component[static_cast<std::size_t>(h / 3)];
  }
  Rim rim;
  rim.has_some.resize(mesh.interior.size(), 0);
  for (const auto& [edge, value] : surplus) {
    const auto& [count, component] = value;
    for (int i = 0; i < std::abs(count); ++i) rim.edges.push_back(edge);
    if (count != 0) rim.has_some[static_cast<std::size_t>(component)] = 1;
  }
  return rim;
}

/// The triangles of the components that have an inside and a rim, or an inside and none.
TriangleMesh componentsWith(bool a_rim, const RepairedMesh& mesh, const Rim& rim) {
  TriangleMesh result;
  result.vertices = mesh.mesh.vertices;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    const auto component = static_cast<std::size_t>(mesh.component[t]);
    if (mesh.interior[component] != Interior::kSurface && (rim.has_some[component] != 0) == a_rim)
      result.triangles.push_back(mesh.mesh.triangles[t]);
  }
  return result;
}

/// Edges as triangles of no area, for their distance.
TriangleMesh edgeMesh(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim) {
  TriangleMesh result;
  result.vertices = vertices;
  for (const auto& [a, b] : rim.edges) result.triangles.push_back({a, b, b});
  return result;
}

double lengthOf(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim) {
  double sum = 0;
  for (const auto& [a, b] : rim.edges) sum += (vertices[static_cast<std::size_t>(b)] - vertices[static_cast<std::size_t>(a)]).norm();
  return sum;
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

// What the winding number may err by.
constexpr double kWindingError = 0.02;

/// What lies inside, by the components that have an inside.
struct Walls {
  Walls(const RepairedMesh& mesh, const Rim& rim)
      : Walls(componentsWith(false, mesh, rim), componentsWith(true, mesh, rim), edgeMesh(mesh.mesh.vertices, rim),
              lengthOf(mesh.mesh.vertices, rim)) {}
  Walls(const TriangleMesh& closed_mesh, const TriangleMesh& open_mesh, const TriangleMesh& rim_edges, double length)
      : closed(closed_mesh),
        open(open_mesh),
        rim(rim_edges),
        rim_length(length),
        volume(signedVolume(closed_mesh) + signedVolume(open_mesh)),
        inverted(hasInvertedRegion(closed_mesh) || hasInvertedRegion(open_mesh)) {}

  double windingNumber(const Eigen::Vector3d& p) const { return closed.signedCrossings(p) + (open.empty() ? 0 : open.windingNumber(p)); }

  /// Radius of a ball about p in which the winding number exceeds 1/2, if no surface is met. Its gradient depends on the rim alone,
  /// as a current's magnetic field does (Biot-Savart): it is at most length / (4 pi d^2) at a distance of d from the rim.
  double insideRadius(const Eigen::Vector3d& p) const {
    const double margin = windingNumber(p) - 0.5 - kWindingError;
    if (margin <= 0) return 0;
    if (open.empty()) return std::numeric_limits<double>::infinity();
    constexpr double kPi = 3.14159265358979323846;
    const double d = rim.nearest(p).distance, k = rim_length / (4 * kPi * margin), b = 2 * d + k;
    return 2 * d * d / (b + std::sqrt(b * b - 4 * d * d));  // r with k r = (d - r)^2
  }

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

  TriangleBvh closed, open, rim;
  double rim_length;
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
      : walls(mesh, rimOf(mesh)), surface(withLoosePoints(mesh), twoSided(mesh, walls.inverted)), interior(interiorOf(mesh)) {}
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
double Solid::signedDistance(const Eigen::Vector3d& p, double to_surface) const {
  return contains(p) ? -std::min(to_surface, impl_->walls.insideRadius(p)) : to_surface;
}
bool Solid::hasOpenings() const {
  return !impl_->walls.open.empty();
}
double Solid::volume() const {
  return impl_->walls.volume;
}
Interior Solid::interior() const {
  return impl_->interior;
}
const TriangleBvh& Solid::surface() const {
  return impl_->surface;
}

}  // namespace collision_hulls
