// Halves that were mirrored and not welded, or a shell and its lid, are open surfaces a little apart. The fan over such a rim is as large
// as the part's cross-section, though what is open is a slit. Here a rim that another one follows within a short distance, in the other
// direction, has an opening of its length times that distance, if this is less than its fan.
//
// The direction tells a slit from a wall's thickness: the rims of the inner and outer surface of an open cup, each turned outward by
// itself, run the same way. Distances are those between vertices, which exceed those between rims, so a slit is missed rather than
// imagined. Points are sorted along the longest axis, and a search along it ends at the distance found: near-linear unless rims crowd in a
// plane.
#include "mesh/slits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/at.h"
#include "base/looks.h"
#include "mesh/orient.h"

namespace collision_hulls {
namespace {

struct RimPoint {
  Eigen::Vector3d place;
  Eigen::Vector3d direction;
  std::size_t loop;
};

/// Surfaces joined by slits, as trees.
class Joined {
 public:
  explicit Joined(std::size_t surfaces) : above_(surfaces) { std::iota(above_.begin(), above_.end(), std::size_t{0}); }

  std::size_t root(std::size_t surface) {
    while (above_[surface] != surface) surface = above_[surface] = above_[above_[surface]];
    return surface;
  }

  void join(std::size_t a, std::size_t b) { above_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> above_;
};

class Slits {
 public:
  Slits(const std::vector<Eigen::Vector3d>& vertices, const std::vector<BoundaryLoop>& loops, const RunControl& control)
      : vertices_(vertices), loops_(loops), look_(control) {
    Eigen::AlignedBox3d box;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      for (std::size_t i = 0; loops[l].returns && i < loops[l].vertices.size(); ++i) {
        look_();
        points_.push_back(point(l, i));
        box.extend(points_.back().place);
      }
    }
    if (!box.isEmpty()) box.sizes().maxCoeff(&axis_);
    std::sort(points_.begin(), points_.end(),
              [&](const RimPoint& a, const RimPoint& b) { return look_(), a.place[axis_] < b.place[axis_]; });
  }

  /// The area of the strip between rim `l` and those that follow it, whose surfaces are joined with its own; `most` if that is no less.
  double area(std::size_t l, double most, Joined& joined) {
    const std::vector<int>& rim = loops_[l].vertices;
    if (!loops_[l].returns) return most;
    double length = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) length += (vertices_[at(rim[(i + 1) % rim.size()])] - vertices_[at(rim[i])]).norm();
    double width = 0;
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const auto [distance, other] = nearest(point(l, i), most / length);
      if (!(distance * length < most)) return most;
      width = std::max(width, distance);
      others.push_back(other);
    }
    for (const std::size_t other : others) joined.join(at(loops_[l].surface), at(loops_[other].surface));
    return width * length;
  }

 private:
  RimPoint point(std::size_t l, std::size_t i) const {
    const std::vector<int>& rim = loops_[l].vertices;
    const std::size_t next = (i + 1) % rim.size(), previous = (i + rim.size() - 1) % rim.size();
    return {vertices_[at(rim[i])], vertices_[at(rim[next])] - vertices_[at(rim[previous])], l};
  }

  /// Distance and loop of the nearest point of another rim that runs the other way; infinity if there is none within `limit`.
  std::pair<double, std::size_t> nearest(const RimPoint& p, double limit) {
    std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), p.loop};
    const auto start =
        std::lower_bound(points_.begin(), points_.end(), p.place[axis_], [&](const RimPoint& q, double x) { return q.place[axis_] < x; });
    const auto try_it = [&](const RimPoint& q) {
      look_();
      if (std::abs(q.place[axis_] - p.place[axis_]) > std::min(limit, best.first)) return false;
      const double distance = (q.place - p.place).norm();
      if (q.loop != p.loop && q.direction.dot(p.direction) < 0 && distance < best.first) best = {distance, q.loop};
      return true;
    };
    for (auto q = start; q != points_.end() && try_it(*q); ++q) {
    }
    for (auto q = start; q != points_.begin() && try_it(*std::prev(q)); --q) {
    }
    return best;
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  const std::vector<BoundaryLoop>& loops_;
  Looks look_;
  std::vector<RimPoint> points_;
  Eigen::Index axis_ = 0;
};

}  // namespace

std::vector<char> closedButForSlits(const std::vector<Eigen::Vector3d>& vertices, std::vector<BoundaryEdge> boundary,
                                    const std::vector<double>& area, const RunControl& control) {
  const std::vector<BoundaryLoop> loops = boundaryLoops(vertices.size(), std::move(boundary), control);
  Slits slits(vertices, loops, control);
  Joined joined(area.size());
  std::vector<double> open(area.size(), 0), openings, areas(area.size(), 0);
  for (std::size_t l = 0; l < loops.size(); ++l) openings.push_back(slits.area(l, fanArea(vertices, loops[l].vertices), joined));
  for (std::size_t l = 0; l < loops.size(); ++l) open[joined.root(at(loops[l].surface))] += openings[l];
  for (std::size_t s = 0; s < area.size(); ++s) areas[joined.root(s)] += area[s];
  std::vector<char> closed;
  for (std::size_t s = 0; s < area.size(); ++s) closed.push_back(open[joined.root(s)] < kSmallOpening * areas[joined.root(s)]);
  return closed;
}

}  // namespace collision_hulls
