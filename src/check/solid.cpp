#include "collision_hulls/check/solid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "check/flat_sheets.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "geometry/own_axes.h"
#include "geometry/pi.h"
#include "mesh/edges.h"
#include "mesh/loose_segments.h"
#include "parallel.h"

namespace collision_hulls {

namespace {

/// Edges, from and to.
using Rim = std::vector<std::array<int, 2>>;

/// Whether a half-edge and its twin, the only other one on its edge, run against each other.
bool isPaired(const std::vector<Triangle>& triangles, const Edges& edges, int h) {
  const int twin = edges.twin[static_cast<std::size_t>(h)];
  return twin >= 0 && startOf(triangles, twin) == endOf(triangles, h);
}

/// The boundary of the oriented surface of the components that have an inside: edges whose triangles do not run along them equally often
/// in both directions, as the surface runs along them, as often as that direction prevails.
Rim rimOf(const RepairedMesh& mesh, const Edges& edges) {
  const std::vector<Triangle>& triangles = mesh.mesh.triangles;
  std::map<std::array<int, 2>, int> surplus;
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    if (isPaired(triangles, edges, h)) continue;
    const int from = startOf(triangles, h), to = endOf(triangles, h);
    const int component = mesh.component[static_cast<std::size_t>(h / 3)];
    if (mesh.interior[static_cast<std::size_t>(component)] == Interior::kSurface) continue;
    surplus[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
  }
  Rim rim;
  for (const auto& [edge, count] : surplus) {
    for (int i = 0; i < count; ++i) rim.push_back(edge);
    for (int i = 0; i < -count; ++i) rim.push_back({edge[1], edge[0]});
  }
  return rim;
}

/// The rim as simple loops, each a list of vertices. It is a cycle: as many of its edges begin at a vertex as end there.
std::vector<std::vector<int>> loopsOf(const Rim& rim) {
  std::map<int, std::vector<int>> onward;  // by vertex: the ends of edges that were not walked yet
  for (const auto& [from, to] : rim) onward[from].push_back(to);
  std::vector<std::vector<int>> loops;
  std::map<int, std::size_t> place;  // on the path
  for (const auto& [from, to] : rim) {
    std::vector<int> path;
    for (int v = from;;) {
      const auto met = place.find(v);
      if (met != place.end()) {
        loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(met->second), path.end());
        for (int u : loops.back()) place.erase(u);
        path.resize(path.size() - loops.back().size());
      }
      if (onward[v].empty()) break;
      place[v] = path.size();
      path.push_back(v);
      const int next = onward[v].back();
      onward[v].pop_back();
      v = next;
    }
  }
  return loops;
}

constexpr double kApexAside = 0.05;  // of a loop's extent

/// Lids that close the surface along its rim: for each loop of it a cone of triangles to a point near its middle, but aside from the
/// plane that it may lie in, where lids would be asked about most.
TriangleMesh lidsOf(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim) {
  TriangleMesh lids;
  if (rim.empty()) return lids;
  lids.vertices = vertices;
  const Eigen::Vector3d aside = Eigen::Vector3d(0.6180339887, -0.4142135624, 0.7320508076).normalized();
  for (const std::vector<int>& loop : loopsOf(rim)) {
    Eigen::AlignedBox3d box;
    for (int v : loop) box.extend(vertices[static_cast<std::size_t>(v)]);
    const int apex = static_cast<int>(lids.vertices.size());
    lids.vertices.push_back(box.center() + kApexAside * box.diagonal().norm() * aside);
    for (std::size_t i = 0; i < loop.size(); ++i) lids.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], apex});
  }
  return lids;
}

/// The triangles of the components that have an inside.
TriangleMesh wallsOf(const RepairedMesh& mesh) {
  TriangleMesh result;
  result.vertices = mesh.mesh.vertices;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    if (mesh.interior[static_cast<std::size_t>(mesh.component[t])] != Interior::kSurface)
      result.triangles.push_back(mesh.mesh.triangles[t]);
  return result;
}

/// Both, which share their first vertices: those of `mesh`.
TriangleMesh joined(const TriangleMesh& mesh, const TriangleMesh& lids) {
  TriangleMesh result = mesh;
  if (!lids.triangles.empty()) result.vertices = lids.vertices;
  result.triangles.insert(result.triangles.end(), lids.triangles.begin(), lids.triangles.end());
  return result;
}

/// Edges as triangles of no area, for their distance.
TriangleMesh edgeMesh(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim) {
  TriangleMesh result;
  if (!rim.empty()) result.vertices = vertices;
  for (const auto& [a, b] : rim) result.triangles.push_back({a, b, b});
  return result;
}

double lengthOf(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim) {
  double sum = 0;
  for (const auto& [a, b] : rim) sum += (vertices[static_cast<std::size_t>(b)] - vertices[static_cast<std::size_t>(a)]).norm();
  return sum;
}

// How many triangles' outer sides are looked at for a winding number below zero.
constexpr std::size_t kMostProbes = 5000;
constexpr double kProbeStep = 1e-3;  // off the triangle, in lengths of its shortest altitude or so

constexpr double kInside = 0.5;  // winding numbers above are those of points inside

// What the winding number may err by.
constexpr double kWindingError = 0.02;

/// What lies inside, by the components that have an inside. The winding number is that of the surface closed with lids, which counting
/// crossings tells, less that of the lids, which are few.
struct Walls {
  /// `surface`: a tree over all triangles, which serves where all of them are walls without a rim.
  Walls(const RepairedMesh& mesh, const Rim& rim_edges, const std::shared_ptr<const TriangleBvh>& surface)
      : Walls(wallsOf(mesh), lidsOf(mesh.mesh.vertices, rim_edges), mesh, rim_edges, surface) {}
  Walls(const TriangleMesh& walls, const TriangleMesh& lid_mesh, const RepairedMesh& mesh, const Rim& rim_edges,
        const std::shared_ptr<const TriangleBvh>& surface)
      : closed(lid_mesh.triangles.empty() && walls.triangles.size() == mesh.mesh.triangles.size()
                   ? surface
                   : std::make_shared<TriangleBvh>(joined(walls, lid_mesh))),
        lids(lid_mesh),
        rim(edgeMesh(mesh.mesh.vertices, rim_edges)),
        rim_length(lengthOf(mesh.mesh.vertices, rim_edges)),
        volume(signedVolume(walls)),
        inverted(hasInvertedRegion(walls)) {}

  double windingNumber(const Eigen::Vector3d& p) const { return closed->signedCrossings(p) - (lids.empty() ? 0 : lids.windingNumber(p)); }

  /// What a path from p has to be longer than if it does not cross the surface and comes from one side of winding number 1/2 to the other;
  /// it is `winding` at p. Its gradient depends on the rim alone, as a current's magnetic field does (Biot-Savart): it is at most
  /// length / (4 pi d^2) at a distance of d from the rim.
  double wayToBorder(const Eigen::Vector3d& p, double winding) const {
    const double margin = std::abs(winding - kInside) - kWindingError;
    if (margin <= 0) return 0;
    if (lids.empty()) return std::numeric_limits<double>::infinity();
    const double d = rim.nearest(p).distance, k = rim_length / (4 * kPi * margin), b = 2 * d + k;
    return 2 * d * d / (b + std::sqrt(b * b - 4 * d * d));  // r with k r = (d - r)^2
  }

  /// Whether some region is enclosed inside out: then a triangle's back may face the outside.
  bool hasInvertedRegion(const TriangleMesh& walls) const {
    const std::size_t n = walls.triangles.size(), stride = std::max<std::size_t>(1, n / kMostProbes);
    std::atomic<bool> found{false};
    forEach((n + stride - 1) / stride, [&](std::size_t probe_number) {
      const int i = static_cast<int>(stride * probe_number);
      const Eigen::Vector3d &a = walls.corner(i, 0), &b = walls.corner(i, 1), &c = walls.corner(i, 2);
      const Eigen::Vector3d normal = (b - a).cross(c - a);
      if (found || !(normal.norm() > 0)) return;
      const Eigen::Vector3d probe = (a + b + c) / 3 + normal.normalized() * (kProbeStep * std::sqrt(normal.norm()));
      if (windingNumber(probe) < -0.5) found = true;
    });
    return found;
  }

  std::shared_ptr<const TriangleBvh> closed;
  TriangleBvh lids, rim;
  double rim_length;
  double volume;
  bool inverted;
};

/// Per triangle of withLoose(): whether both of its sides may face the outside.
std::vector<char> twoSided(const RepairedMesh& mesh, const Edges& edges) {
  const std::vector<Triangle>& triangles = mesh.mesh.triangles;
  std::vector<char> result(triangles.size() + mesh.loose.size(), 1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const int h = static_cast<int>(3 * t);
    const auto endsSheet = [&](int half_edge) {
      return edges.twin[static_cast<std::size_t>(half_edge)] != Edges::kNonManifold && !isPaired(triangles, edges, half_edge);
    };
    result[t] = mesh.interior[static_cast<std::size_t>(mesh.component[t])] == Interior::kSurface || endsSheet(h) || endsSheet(h + 1) ||
                endsSheet(h + 2);
  }
  return result;
}

}  // namespace

struct Solid::Impl {
  explicit Impl(const RepairedMesh& mesh) : Impl(mesh, findEdges(mesh.mesh.triangles, mesh.mesh.vertices.size())) {}
  Impl(const RepairedMesh& mesh, const Edges& edges) : Impl(mesh, edges, twoSided(mesh, edges)) {}
  Impl(const RepairedMesh& mesh, const Edges& edges, std::vector<char> two_sided)
      : surface(std::make_shared<TriangleBvh>(withLoose(mesh), two_sided)),
        walls(mesh, rimOf(mesh, edges), surface),
        interior(interiorOf(mesh)),
        axes(ownAxes(mesh.mesh)),
        weld_distance(mesh.counts.weld_distance),
        component_points(pointsOfComponents(mesh)) {
    if (walls.inverted) {
      std::fill(two_sided.begin(), two_sided.end(), 1);
      surface = std::make_shared<TriangleBvh>(withLoose(mesh), two_sided);
    }
    sheets = std::make_unique<FlatSheets>(mesh, edges, two_sided);
  }
  std::shared_ptr<const TriangleBvh> surface;
  Walls walls;
  std::unique_ptr<const FlatSheets> sheets;
  Interior interior;
  Eigen::Matrix3d axes;
  double weld_distance;
  std::vector<Eigen::Vector3d> component_points;
};

Solid::Solid(const RepairedMesh& mesh, const RunControl& control) {
  control.check();
  impl_ = std::make_unique<Impl>(mesh);
}
Solid::~Solid() = default;
Solid::Solid(Solid&&) noexcept = default;

bool Solid::contains(const Eigen::Vector3d& p) const {
  return impl_->walls.windingNumber(p) > kInside;
}
double Solid::distanceToSurface(const Eigen::Vector3d& p) const {
  return impl_->surface->nearest(p).distance;
}
double Solid::distance(const Eigen::Vector3d& p) const {
  return contains(p) ? 0 : distanceToSurface(p);
}
double Solid::signedDistance(const Eigen::Vector3d& p, double to_surface) const {
  const double winding = impl_->walls.windingNumber(p);
  return winding > kInside ? -std::min(to_surface, impl_->walls.wayToBorder(p, winding)) : to_surface;
}

double Solid::distanceWithin(double radius, double signed_distance, double to_surface) const {
  const double bound = std::max(0.0, signed_distance + radius);
  return std::signbit(signed_distance) && bound > 0 && hasOpenings() ? to_surface + radius : bound;  // the ball may be a point: -0
}
double Solid::wayToBorder(const Eigen::Vector3d& p) const {
  return hasOpenings() ? impl_->walls.wayToBorder(p, impl_->walls.windingNumber(p)) : std::numeric_limits<double>::infinity();
}
bool Solid::hasOpenings() const {
  return !impl_->walls.lids.empty();
}
double Solid::volume() const {
  return impl_->walls.volume;
}
Interior Solid::interior() const {
  return impl_->interior;
}
double Solid::heightAboveSheet(const std::array<Eigen::Vector3d, 3>& patch, const TriangleBvh::Nearest& near, double slack) const {
  return impl_->sheets->bound(patch, near, slack);
}
const Eigen::Matrix3d& Solid::axes() const {
  return impl_->axes;
}
double Solid::weldDistance() const {
  return impl_->weld_distance;
}
const std::vector<Eigen::Vector3d>& Solid::componentPoints() const {
  return impl_->component_points;
}
const TriangleBvh& Solid::surface() const {
  return *impl_->surface;
}

}  // namespace collision_hulls
