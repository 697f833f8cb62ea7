// Opposite boundary edges cancel first; what remains splits into simple loops, and each loop gets a fan about its mean vertex. Near-linear:
// two sorts and one walk over the edges.
#include "mesh/boundary.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/at.h"
#include "base/looks.h"
#include "mesh/edges.h"

namespace collision_hulls {
namespace {

using Boundary = std::vector<BoundaryEdge>;

std::tuple<int, int, int> undirected(const BoundaryEdge& e) {
  return {e.surface, std::min(e.from, e.to), std::max(e.from, e.to)};
}

/// For each undirected edge, keeps the surplus of one direction over the other.
Boundary withoutOpposites(Boundary edges, const RunControl& control) {
  Looks look(control);
  std::sort(edges.begin(), edges.end(),
            [&](const BoundaryEdge& a, const BoundaryEdge& b) { return look(), undirected(a) < undirected(b); });
  Boundary kept;
  for (auto first = edges.begin(); first != edges.end();) {
    look();
    const auto last = std::find_if(first, edges.end(), [&](const BoundaryEdge& e) { return undirected(e) != undirected(*first); });
    const auto rising = std::count_if(first, last, [](const BoundaryEdge& e) { return e.from < e.to; });
    const auto surplus = 2 * rising - (last - first);
    const auto [surface, low, high] = undirected(*first);
    for (auto i = surplus; i > 0; --i) kept.push_back({surface, low, high});
    for (auto i = surplus; i < 0; ++i) kept.push_back({surface, high, low});
    first = last;
  }
  return kept;
}

/// Splits each surface's edges into simple loops. A walk follows unused edges; whenever it reaches a vertex of its own path, the path since
/// that vertex is a loop and is taken off.
class LoopWalk {
 public:
  /// `edges`: sorted by surface, then by start vertex.
  LoopWalk(std::size_t vertices, const Boundary& edges, const RunControl& control)
      : edges_(edges), look_(control), next_(vertices, 0), place_(vertices, kNowhere) {}

  /// Adds the loops of the surface with the edges [begin, end).
  void split(std::size_t begin, std::size_t end, std::vector<BoundaryLoop>& loops) {
    loops_ = &loops;
    surface_ = edges_[begin].surface;
    end_ = end;
    for (std::size_t e = end; e-- > begin;) next_[start(e)] = e;
    for (std::size_t e = begin; e < end; ++e)
      while (hasNext(start(e))) walk(start(e));
  }

 private:
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  std::size_t start(std::size_t e) const { return static_cast<std::size_t>(edges_[e].from); }
  bool hasNext(std::size_t v) const { return next_[v] < end_ && start(next_[v]) == v; }

  void walk(std::size_t v) {
    while (true) {
      look_();
      if (place_[v] != kNowhere) cut(place_[v], true);
      place_[v] = path_.size();
      path_.push_back(static_cast<int>(v));
      if (!hasNext(v)) break;
      v = static_cast<std::size_t>(edges_[next_[v]++].to);
    }
    if (path_.size() > 1) {
      cut(0, false);
    } else {
      drop(0);
    }
  }

  /// Takes the path from place `first` on as a loop.
  void cut(std::size_t first, bool returns) {
    loops_->push_back({surface_, {path_.begin() + static_cast<std::ptrdiff_t>(first), path_.end()}, returns});
    drop(first);
  }

  void drop(std::size_t first) {
    for (std::size_t i = first; i < path_.size(); ++i) place_[static_cast<std::size_t>(path_[i])] = kNowhere;
    path_.resize(first);
  }

  const Boundary& edges_;
  Looks look_;
  std::vector<BoundaryLoop>* loops_ = nullptr;
  int surface_ = 0;
  std::size_t end_ = 0;             // end of the current surface's edges
  std::vector<std::size_t> next_;   // per vertex: the first unused edge that starts there
  std::vector<std::size_t> place_;  // per vertex: its place on the path, or kNowhere
  std::vector<int> path_;
};

/// Adds the fan over a loop about its mean vertex.
void addFan(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& loop, const Eigen::Vector3d& origin, Closure& closure) {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const int v : loop) center += vertices[at(v)] - origin;
  center /= static_cast<double>(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = vertices[at(loop[i])] - origin;
    const Eigen::Vector3d b = vertices[at(loop[i + 1 < loop.size() ? i + 1 : 0])] - origin;
    closure.area += (a - center).cross(b - center).norm() / 2;
    closure.volume += b.cross(a).dot(center) / 6;
  }
}

}  // namespace

double triangleArea(const TriangleMesh& mesh, int triangle) {
  const Eigen::Vector3d& a = mesh.corner(triangle, 0);
  return (mesh.corner(triangle, 1) - a).cross(mesh.corner(triangle, 2) - a).norm() / 2;
}

double volumeBehind(const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& origin) {
  const Eigen::Vector3d a = mesh.corner(triangle, 0) - origin, b = mesh.corner(triangle, 1) - origin, c = mesh.corner(triangle, 2) - origin;
  return a.cross(b).dot(c) / 6;
}

BoundaryEdge boundaryEdge(const TriangleMesh& mesh, int half_edge, const std::vector<char>& turn, const std::vector<int>& surface) {
  const auto triangle = static_cast<std::size_t>(half_edge / 3);
  BoundaryEdge edge{surface[triangle], startOf(mesh.triangles, half_edge), endOf(mesh.triangles, half_edge)};
  if (turn[triangle]) std::swap(edge.from, edge.to);
  return edge;
}

std::vector<BoundaryLoop> boundaryLoops(std::size_t vertices, std::vector<BoundaryEdge> boundary, const RunControl& control) {
  Boundary edges = withoutOpposites(std::move(boundary), control);
  Looks look(control);
  std::sort(edges.begin(), edges.end(), [&](const BoundaryEdge& a, const BoundaryEdge& b) {
    look();
    return std::tie(a.surface, a.from, a.to) < std::tie(b.surface, b.from, b.to);
  });
  std::vector<BoundaryLoop> loops;
  LoopWalk walk(vertices, edges, control);
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin;
    while (end < edges.size() && edges[end].surface == edges[begin].surface) ++end;
    walk.split(begin, end, loops);
    begin = end;
  }
  return loops;
}

double fanArea(const std::vector<Eigen::Vector3d>& vertices, const std::vector<int>& loop) {
  Closure closure;
  addFan(vertices, loop, Eigen::Vector3d::Zero(), closure);
  return closure.area;
}

std::vector<Closure> closures(const std::vector<Eigen::Vector3d>& vertices, std::vector<BoundaryEdge> boundary, std::size_t surfaces,
                              const Eigen::Vector3d& origin, const RunControl& control) {
  Looks look(control);
  std::vector<Closure> result(surfaces);
  for (const BoundaryLoop& loop : boundaryLoops(vertices.size(), std::move(boundary), control)) {
    look();
    addFan(vertices, loop.vertices, origin, result[at(loop.surface)]);
  }
  return result;
}

}  // namespace collision_hulls
