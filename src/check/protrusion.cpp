// Branch and bound over tetrahedra. An interior point joined to each of its triangles divides a hull into tetrahedra, so that
// faces and interior are searched alike, and a cavity within a hull is found as well as a bulge.
//
//   put the tetrahedra of all hulls into a queue, largest bound first
//   until the largest bound is at most found + gap:
//     take it, halve it at its longest edge, and put back both halves with the bounds of bound()
//
// The distance f to the solid is 1-Lipschitz: within a radius r of the centre c it is at most f(c) + r. That bound closes slowly
// where f is level; there the distance to the one triangle nearest to c helps, which is convex: its largest value lies at a corner.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "collision_hulls/check/measures.h"

namespace collision_hulls {

namespace {

constexpr int kStepsBetweenChecks = 1024;

struct Tetrahedron {
  std::array<Eigen::Vector3d, 4> corner;
  double bound = 0;
  int hint = -1;  // triangle of the surface nearest to the parent's centre

  bool operator<(const Tetrahedron& other) const { return bound < other.bound; }
  Eigen::Vector3d centre() const { return (corner[0] + corner[1] + corner[2] + corner[3]) / 4; }
};

/// The search over one hull.
class Search {
 public:
  Search(const Solid& solid, double floor, double gap) : solid_(solid), floor_(floor), gap_(gap) {}

  Protrusion run(const ConvexHull& hull, const RunControl& control) {
    Eigen::Vector3d apex = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& v : hull.vertices) apex += v / static_cast<double>(hull.vertices.size());
    for (const Eigen::Vector3d& v : hull.vertices) visit(v, -1);
    for (const Triangle& t : hull.triangles) {
      const auto at = [&](int i) { return hull.vertices[static_cast<std::size_t>(i)]; };
      push({{apex, at(t[0]), at(t[1]), at(t[2])}, 0, -1});
    }
    for (int step = 0; !queue_.empty() && queue_.top().bound > threshold(); ++step) {
      if (step % kStepsBetweenChecks == 0) control.check();
      halve();
    }
    best_.bound = queue_.empty() ? best_.found : std::max(best_.found, std::min(queue_.top().bound, threshold()));
    best_.bound = std::max(best_.bound, dropped_);
    return best_;
  }

 private:
  /// What a tetrahedron must promise to exceed to be worth halving.
  double threshold() const { return std::max(best_.found, floor_) + gap_; }

  /// The distance of p from the solid is a candidate for the largest. Returns the distance to the surface, negative inside.
  double visit(const Eigen::Vector3d& p, int hint, TriangleBvh::Nearest* nearest = nullptr) {
    const TriangleBvh::Nearest n = solid_.surface().nearest(p, std::numeric_limits<double>::infinity(), hint);
    if (nearest) *nearest = n;
    if (n.distance <= best_.found) return n.distance;  // whichever side: not a candidate
    if (solid_.contains(p)) return -n.distance;
    best_.found = n.distance, best_.where = p, best_.nearest = n.point;
    return n.distance;
  }

  void push(Tetrahedron t) {
    const Eigen::Vector3d c = t.centre();
    double radius = 0;
    for (const Eigen::Vector3d& v : t.corner) radius = std::max(radius, (v - c).norm());
    TriangleBvh::Nearest n;
    const double before = best_.found;
    double d = visit(c, t.hint, &n);
    t.hint = n.triangle;
    double level = 0;
    for (const Eigen::Vector3d& v : t.corner) {
      const auto& [a, b, e] = solid_.surface().corners(n.triangle);
      level = std::max(level, (closestPoint(a, b, e, v) - v).norm());
    }
    // A small distance is not a candidate and its side was not asked for; it matters only where the bound would stay open.
    if (d >= 0 && d <= before && std::min(d + radius, level) > threshold() && solid_.contains(c)) d = -d;
    t.bound = std::min(std::max(0.0, d + radius), level);
    if (t.bound > threshold())
      queue_.push(t);
    else
      dropped_ = std::max(dropped_, t.bound);
  }

  void halve() {
    Tetrahedron t = queue_.top();
    queue_.pop();
    std::size_t a = 0, b = 1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if ((t.corner[i] - t.corner[j]).squaredNorm() > (t.corner[a] - t.corner[b]).squaredNorm()) a = i, b = j;
    const Eigen::Vector3d middle = (t.corner[a] + t.corner[b]) / 2;
    Tetrahedron other = t;
    t.corner[b] = other.corner[a] = middle;
    push(t);
    push(other);
  }

  const Solid& solid_;
  double floor_, gap_, dropped_ = 0;
  std::priority_queue<Tetrahedron> queue_;
  Protrusion best_;
};

}  // namespace

Protrusion protrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, double gap, const RunControl& control) {
  // Vertices first: what they reach is a floor that spares the other hulls most of the search.
  double floor = 0;
  std::vector<Protrusion> each(hulls.size());
  for (const ConvexHull& hull : hulls)
    for (const Eigen::Vector3d& v : hull.vertices)
      if (solid.distanceToSurface(v) > floor) floor = std::max(floor, solid.distance(v));
  tbb::parallel_for(std::size_t{0}, hulls.size(), [&](std::size_t i) {
    each[i] = Search(solid, floor, gap).run(hulls[i], control);
    each[i].hull = static_cast<int>(i);
  });
  Protrusion worst;
  for (const Protrusion& p : each) {
    const double bound = std::max(worst.bound, p.bound);
    if (p.found > worst.found) worst = p;
    worst.bound = bound;
  }
  return worst;
}

}  // namespace collision_hulls
