// Branch and bound over tetrahedra. An interior point joined to each of its triangles divides a hull into tetrahedra, so that
// faces and interior are searched alike, and a cavity within a hull is found as well as a bulge.
//
//   put the tetrahedra of all hulls into a queue, largest bound first
//   until the largest bound is at most found + gap:
//     take it, halve it at its longest edge, and put back both halves with the bounds of bound()
//
// The distance f to the solid is 1-Lipschitz: within a radius r of the centre c it is at most f(c) + r. That closes slowly where
// f is level, beside a wall or midway between two. There the distances d_j to a few single triangles help: f <= min_j d_j <=
// sum_j w_j d_j for any weights w that sum to 1, and that sum is convex: its largest value over a tetrahedron lies at a corner.
// The best weights are those of a small matrix game, corner against triangle.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "collision_hulls/check/measures.h"

namespace collision_hulls {

namespace {

constexpr int kStepsBetweenChecks = 1024;

/// A corner of tetrahedra, and the triangle of the surface nearest to it.
struct Corner {
  Eigen::Vector3d p;
  int triangle = -1;
};

struct Tetrahedron {
  std::array<Corner, 4> corner;
  double bound = 0;

  bool operator<(const Tetrahedron& other) const { return bound < other.bound; }
  Eigen::Vector3d centre() const { return (corner[0].p + corner[1].p + corner[2].p + corner[3].p) / 4; }
};

constexpr int kGameRounds = 24;
using Game = Eigen::Matrix<double, 4, Eigen::Dynamic, 0, 4, 5>;  // distance of each corner to each triangle

/// An upper bound of min over weights of max over corners, by fictitious play: any weights give a bound, good ones a tight one.
double gameValue(const Game& distance) {
  Eigen::Vector4d total = Eigen::Vector4d::Zero();
  double best = std::numeric_limits<double>::infinity();
  Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 5> against = distance.colwise().sum() / 4;
  for (int round = 1; round <= kGameRounds; ++round) {
    int triangle = 0, corner = 0;
    against.minCoeff(&triangle);
    total += distance.col(triangle);
    best = std::min(best, total.maxCoeff(&corner) / round);
    if (round == 1) against.setZero();
    against += distance.row(corner);
  }
  for (int j = 0; j < distance.cols(); ++j) best = std::min(best, distance.col(j).maxCoeff());
  return best;
}

/// The search over one hull.
class Search {
 public:
  Search(const Solid& solid, double floor, double gap) : solid_(solid), floor_(floor), gap_(gap) {}

  Protrusion run(const ConvexHull& hull, const RunControl& control) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& v : hull.vertices) middle += v / static_cast<double>(hull.vertices.size());
    std::vector<Corner> corners;
    for (const Eigen::Vector3d& v : hull.vertices) corners.push_back(visit(v, corners.empty() ? -1 : corners.back().triangle));
    const Corner apex = visit(middle, corners.back().triangle);
    for (const Triangle& t : hull.triangles) {
      const auto at = [&](std::size_t k) { return corners[static_cast<std::size_t>(t[k])]; };
      push({{apex, at(0), at(1), at(2)}, 0});
    }
    for (int step = 0; !queue_.empty() && queue_.top().bound > threshold(); ++step) {
      if (step % kStepsBetweenChecks == 0) control.check();
      halve();
    }
    best_.bound = std::max(best_.found, dropped_);
    if (!queue_.empty()) best_.bound = std::max(best_.bound, queue_.top().bound);
    return best_;
  }

 private:
  /// What a tetrahedron must promise to exceed to be worth halving.
  double threshold() const { return std::max(best_.found, floor_) + gap_; }

  /// A corner at p, whose distance from the solid is a candidate for the largest.
  Corner visit(const Eigen::Vector3d& p, int hint) {
    const TriangleBvh::Nearest n = solid_.surface().nearest(p, std::numeric_limits<double>::infinity(), hint);
    if (n.distance > best_.found && !solid_.contains(p)) best_.found = n.distance, best_.where = p, best_.nearest = n.point;
    return {p, n.triangle};
  }

  double distanceTo(int triangle, const Eigen::Vector3d& p) const {
    const auto& [a, b, c] = solid_.surface().corners(triangle);
    return (closestPoint(a, b, c, p) - p).norm();
  }

  /// Bound by the distances to the triangles nearest to the corners and, where there is one, to the centre.
  double levelBound(const Tetrahedron& t, int centre_triangle) const {
    Game game(4, 0);
    for (std::size_t j = 0; j < 5; ++j) {
      const int triangle = j < 4 ? t.corner[j].triangle : centre_triangle;
      bool known = triangle < 0;
      for (std::size_t k = 0; k < j && !known; ++k) known = t.corner[k].triangle == triangle;
      if (known) continue;
      game.conservativeResize(4, game.cols() + 1);
      for (int i = 0; i < 4; ++i) game(i, game.cols() - 1) = distanceTo(triangle, t.corner[static_cast<std::size_t>(i)].p);
    }
    return gameValue(game);
  }

  void push(Tetrahedron t) {
    t.bound = levelBound(t, -1);
    if (t.bound > threshold()) {
      const Eigen::Vector3d c = t.centre();
      double radius = 0;
      for (const Corner& v : t.corner) radius = std::max(radius, (v.p - c).norm());
      const TriangleBvh::Nearest n = solid_.surface().nearest(c, std::numeric_limits<double>::infinity(), t.corner[0].triangle);
      const double outside = solid_.contains(c) ? -n.distance : n.distance;
      if (outside > best_.found) best_.found = outside, best_.where = c, best_.nearest = n.point;
      t.bound = std::min({t.bound, std::max(0.0, outside + radius), levelBound(t, n.triangle)});
    }
    if (t.bound > threshold())
      queue_.push(t);
    else
      dropped_ = std::max(dropped_, t.bound);
  }

  void halve() {
    Tetrahedron t = queue_.top();
    queue_.pop();
    std::size_t a = 0, b = 1;
    const auto length = [&](std::size_t i, std::size_t j) { return (t.corner[i].p - t.corner[j].p).squaredNorm(); };
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (length(i, j) > length(a, b)) a = i, b = j;
    const Corner middle = visit((t.corner[a].p + t.corner[b].p) / 2, t.corner[a].triangle);
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
