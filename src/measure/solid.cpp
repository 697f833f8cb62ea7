// Tells inside from outside by the winding number of the surface. The rim (edges whose triangles are unbalanced) falls into loops: narrow
// ones are cracks, closed by lids that count as surface; the others are openings, closed by cones. The closed surface's winding number is a
// count of ray crossings; subtracting that of the cones gives the generalized winding number at little more cost. Near openings, the
// number's gradient bounds how far the border of the solid can be (Biot-Savart).
#include "collision_hulls/measure/solid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "base/parallel.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "geometry/own_axes.h"
#include "geometry/pi.h"
#include "measure/flat_sheets.h"
#include "mesh/edges.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

/// Edges as pairs (from, to).
using Rim = std::vector<std::array<int, 2>>;

/// Whether a half-edge and its twin, the only other one on its edge, run in opposite directions.
bool isPaired(const std::vector<Triangle>& triangles, const Edges& edges, int h) {
  const int twin = edges.twin[static_cast<std::size_t>(h)];
  return twin >= 0 && startOf(triangles, twin) == endOf(triangles, h);
}

/// The boundary of the oriented surface without its sheets: the edges that triangles do not use equally often in both directions, in the
/// direction that prevails and as many times as it does.
Rim rimOf(const RepairedMesh& mesh, const Edges& edges) {
  const std::vector<Triangle>& triangles = mesh.mesh.triangles;
  std::map<std::array<int, 2>, int> surplus;
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    if (isPaired(triangles, edges, h)) continue;
    const int from = startOf(triangles, h), to = endOf(triangles, h);
    if (mesh.sheet[static_cast<std::size_t>(h / 3)]) continue;
    surplus[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
  }
  Rim rim;
  for (const auto& [edge, count] : surplus) {
    for (int i = 0; i < count; ++i) rim.push_back(edge);
    for (int i = 0; i < -count; ++i) rim.push_back({edge[1], edge[0]});
  }
  return rim;
}

/// Takes the outgoing edge at v that turns back most; the two sides of a crack then form one loop.
int takeOnward(const std::vector<Eigen::Vector3d>& vertices, int before, int v, std::vector<int>* ends) {
  const auto at = [&](int i) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(i)]; };
  const Eigen::Vector3d back = at(before) - at(v);
  const auto turn = [&](int end) { return (at(end) - at(v)).normalized().dot(back); };
  auto taken = ends->end() - 1;
  if (before != v && ends->size() > 1)
    taken = std::max_element(ends->begin(), ends->end(), [&](int a, int b) { return turn(a) < turn(b); });
  const int next = *taken;
  ends->erase(taken);
  return next;
}

/// A simple cycle of vertices.
using Loop = std::vector<int>;

/// Splits the rim into loops. It is a cycle: at each vertex as many of its edges begin as end.
std::vector<Loop> loopsOf(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim) {
  std::map<int, std::vector<int>> onward;  // per vertex: the end points of edges not walked yet
  for (const auto& [from, to] : rim) onward[from].push_back(to);
  std::vector<Loop> loops;
  std::map<int, std::size_t> place;  // on the path
  for (const auto& [from, to] : rim) {
    Loop path;
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
      v = takeOnward(vertices, path.size() > 1 ? path[path.size() - 2] : v, v, &onward[v]);
    }
  }
  return loops;
}

/// [m] An upper bound on the distance of the loop, and of any surface spanning it, from a segment along which the loop runs there and back.
double widthOf(const std::vector<Eigen::Vector3d>& vertices, const Loop& loop) {
  const auto at = [&](int v) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(v)]; };
  const auto furthestFrom = [&](int v) {
    return *std::max_element(loop.begin(), loop.end(), [&](int a, int b) { return (at(a) - at(v)).norm() < (at(b) - at(v)).norm(); });
  };
  const int end = furthestFrom(loop[0]);
  const Eigen::Vector3d from = at(end), along = at(furthestFrom(end)) - from;
  double width = 0;
  for (const int v : loop) {
    const double share = std::clamp((at(v) - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    width = std::max(width, (at(v) - from - share * along).norm());
  }
  return width;
}

/// What closes the surface along its rim. A loop no wider than the weld tolerance is a crack, as where one triangle's long side meets two
/// short ones: its lids lie within it and count as surface wherever inside and outside are told apart. Other loops are openings.
struct Lids {
  std::vector<Eigen::Vector3d> vertices;  // those of the surface, and apexes
  std::vector<Triangle> of_cracks, of_openings;
  Rim rim_of_openings;
  double crack_width = 0;  // [m] of the widest crack
};

constexpr double kApexAside = 0.05;  // as a share of a loop's extent

/// An opening gets a cone of triangles with its apex near the loop's middle, but off the plane that the loop may lie in, where queries are
/// most frequent.
Lids lidsOf(const TriangleMesh& mesh, const Rim& rim) {
  Lids lids;
  if (rim.empty()) return lids;
  lids.vertices = mesh.vertices;
  const double widest_crack = RepairOptions{}.weld_tolerance * boundingBox(mesh).sizes().maxCoeff();
  const Eigen::Vector3d aside = Eigen::Vector3d(0.6180339887, -0.4142135624, 0.7320508076).normalized();
  for (const Loop& loop : loopsOf(mesh.vertices, rim)) {
    const double width = widthOf(mesh.vertices, loop);
    if (width <= widest_crack) {
      for (std::size_t i = 2; i < loop.size(); ++i) lids.of_cracks.push_back({loop[i], loop[i - 1], loop[0]});
      lids.crack_width = std::max(lids.crack_width, width);
      continue;
    }
    Eigen::AlignedBox3d box;
    for (int v : loop) box.extend(mesh.vertices[static_cast<std::size_t>(v)]);
    const int apex = static_cast<int>(lids.vertices.size());
    lids.vertices.push_back(box.center() + kApexAside * box.diagonal().norm() * aside);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int next = loop[(i + 1) % loop.size()];
      lids.of_openings.push_back({next, loop[i], apex});
      lids.rim_of_openings.push_back({loop[i], next});
    }
  }
  return lids;
}

/// The triangles that are not in sheets.
TriangleMesh wallsOf(const RepairedMesh& mesh) {
  TriangleMesh result;
  result.vertices = mesh.mesh.vertices;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    if (!mesh.sheet[t]) result.triangles.push_back(mesh.mesh.triangles[t]);
  return result;
}

/// The closed surface.
TriangleMesh joined(const TriangleMesh& mesh, const Lids& lids) {
  TriangleMesh result = mesh;
  if (!lids.vertices.empty()) result.vertices = lids.vertices;
  for (const std::vector<Triangle>* triangles : {&lids.of_cracks, &lids.of_openings})
    result.triangles.insert(result.triangles.end(), triangles->begin(), triangles->end());
  return result;
}

/// Edges as triangles without area, for distance queries.
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

// Triangles whose outer side is probed for a negative winding number.
constexpr std::size_t kMostProbes = 5000;
constexpr double kProbeStep = 1e-3;  // off the triangle, roughly in lengths of its shortest altitude

// With openings: points with a larger winding number are inside; error bound of our winding numbers.
constexpr double kSurelyInside = 0.55, kWindingError = 0.02;

/// What lies inside. The winding number is that of the closed surface, by counting crossings, minus that of the lids of openings, which are
/// few.
struct Walls {
  /// `surface`: a tree over all triangles, reused if all of them are walls and there is no rim.
  Walls(const RepairedMesh& mesh, const Rim& rim_edges, const std::shared_ptr<const TriangleBvh>& surface)
      : Walls(wallsOf(mesh), lidsOf(mesh.mesh, rim_edges), mesh, surface) {}
  Walls(const TriangleMesh& walls, const Lids& all_lids, const RepairedMesh& mesh, const std::shared_ptr<const TriangleBvh>& surface)
      : closed(all_lids.vertices.empty() && walls.triangles.size() == mesh.mesh.triangles.size()
                   ? surface
                   : std::make_shared<TriangleBvh>(joined(walls, all_lids))),
        lids({all_lids.vertices, all_lids.of_openings}),
        rim(edgeMesh(mesh.mesh.vertices, all_lids.rim_of_openings)),
        rim_length(lengthOf(mesh.mesh.vertices, all_lids.rim_of_openings)),
        crack_width(all_lids.crack_width),
        volume(signedVolume(walls)),
        inverted(hasInvertedRegion(walls)) {}

  /// Points with a larger winding number are inside. With openings, points that might be outside count as outside, so that no hull reaches
  /// there unnoticed.
  double inside() const { return lids.empty() ? 0.5 : kSurelyInside; }

  double windingNumber(const Eigen::Vector3d& p) const { return closed->signedCrossings(p) - (lids.empty() ? 0 : lids.windingNumber(p)); }

  /// A lower bound on the length of any path from p, where the winding number is `winding`, to the other side of inside() that does not
  /// cross the surface. Away from the surface the winding number's gradient depends only on the rim, like the magnetic field of a current
  /// (Biot-Savart): at a distance d from the rim it is at most length / (4 pi d^2).
  double wayToBorder(const Eigen::Vector3d& p, double winding) const {
    const double margin = std::abs(winding - inside()) - kWindingError;
    if (margin <= 0) return 0;
    if (lids.empty()) return std::numeric_limits<double>::infinity();
    const double d = rim.nearest(p).distance, k = rim_length / (4 * kPi * margin), b = 2 * d + k;
    return 2 * d * d / (b + std::sqrt(b * b - 4 * d * d));  // the r with k r = (d - r)^2
  }

  /// Whether the surface encloses some region inside out; a triangle's back may then face the outside.
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
  double rim_length;   // [m]
  double crack_width;  // [m]
  double volume;
  bool inverted;
};

/// Per triangle of withLoose(): whether either side may face the outside.
std::vector<char> twoSided(const RepairedMesh& mesh, const Edges& edges) {
  const std::vector<Triangle>& triangles = mesh.mesh.triangles;
  std::vector<char> result(triangles.size() + mesh.loose.size(), 1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const int h = static_cast<int>(3 * t);
    const auto endsSheet = [&](int half_edge) {
      return edges.twin[static_cast<std::size_t>(half_edge)] != Edges::kNonManifold && !isPaired(triangles, edges, half_edge);
    };
    result[t] = mesh.sheet[t] || endsSheet(h) || endsSheet(h + 1) || endsSheet(h + 2);
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
  return impl_->walls.windingNumber(p) > impl_->walls.inside();
}
double Solid::distanceToSurface(const Eigen::Vector3d& p) const {
  return impl_->surface->nearest(p).distance;
}
double Solid::distance(const Eigen::Vector3d& p) const {
  return contains(p) ? 0 : distanceToSurface(p);
}
bool Solid::isWithin(double distance, const Eigen::Vector3d& p) const {
  return impl_->surface->nearest(p, distance).triangle >= 0 || contains(p);
}
double Solid::signedDistance(const Eigen::Vector3d& p, double to_surface) const {
  const Walls& walls = impl_->walls;
  const double winding = walls.windingNumber(p);
  if (winding <= walls.inside()) return to_surface;
  // A crack's lids are nowhere further from the surface than twice its width; the same holds for what lies behind them when they are
  // crossed.
  return -std::max(0.0, std::min(to_surface - crackSlack(), walls.wayToBorder(p, winding)));
}
double Solid::crackSlack() const {
  return 4 * impl_->walls.crack_width;
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
