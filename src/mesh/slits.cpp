// Halves that were mirrored and not welded, or a shell and its lid, are open surfaces a little apart. The fan over such a rim is as large
// as the part's cross-section, though what is open is a slit. Here a rim that another one follows within a short distance, in the other
// direction, has an opening of its length times that distance, if this is less than its fan.
//
// The direction tells a slit from a wall's thickness: the rims of the inner and outer surface of an open cup, each turned outward by
// itself, run the same way. Distances are those between vertices, which exceed those between rims, so a slit is missed rather than
// imagined; so it is where very many points are nearer than the other rim, as in stacks of sheets. Near-linear.
#include "mesh/slits.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/looks.h"
#include "geometry/point_tree.h"
#include "mesh/orient.h"

namespace collision_hulls {
namespace {

struct RimPoint {
  Eigen::Vector3d place;
  Eigen::Vector3d direction;
  std::size_t loop;
};

constexpr std::size_t kMostTried = 1000;  // points, for each point of a rim
constexpr std::size_t kMostRims = 1000;   // of more, each single facet may be one: to tell inside from outside would take minutes

class Slits {
 public:
  Slits(const std::vector<Eigen::Vector3d>& vertices, const std::vector<BoundaryLoop>& loops, const RunControl& control)
      : vertices_(vertices), loops_(loops), look_(control) {
    for (std::size_t l = 0; l < loops.size(); ++l) {
      for (std::size_t i = 0; loops[l].returns && i < loops[l].vertices.size(); ++i) {
        look_();
        points_.push_back(point(l, i));
      }
    }
    std::vector<Eigen::Vector3d> places;
    for (const RimPoint& p : points_) places.push_back(p.place);
    tree_.emplace(std::move(places));
  }

  /// The area of the strip between rim `l` and those that follow it, whose surfaces are joined with its own; `most` if that is no less.
  double area(std::size_t l, double most, DisjointSets& joined) {
    const std::vector<int>& rim = loops_[l].vertices;
    if (!loops_[l].returns) return most;
    double length = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) length += (vertices_[at(rim[(i + 1) % rim.size()])] - vertices_[at(rim[i])]).norm();
    double width = 0;
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const RimPoint p = point(l, i);
      const RimPoint* other = nearest(p, most / length);
      if (!other) return most;
      width = std::max(width, (other->place - p.place).norm());
      others.push_back(other->loop);
    }
    for (const std::size_t other : others) joined.join(loops_[l].surface, loops_[other].surface);
    return width * length;
  }

 private:
  RimPoint point(std::size_t l, std::size_t i) const {
    const std::vector<int>& rim = loops_[l].vertices;
    const std::size_t next = (i + 1) % rim.size(), previous = (i + rim.size() - 1) % rim.size();
    return {vertices_[at(rim[i])], vertices_[at(rim[next])] - vertices_[at(rim[previous])], l};
  }

  /// The nearest point of another rim that runs the other way; null if there is none within `limit`.
  const RimPoint* nearest(const RimPoint& p, double limit) {
    const auto other = tree_->nearest(p.place, limit, kMostTried, [&](std::size_t i) {
      look_();
      return points_[i].loop != p.loop && points_[i].direction.dot(p.direction) < 0;
    });
    return other ? &points_[*other] : nullptr;
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  const std::vector<BoundaryLoop>& loops_;
  Looks look_;
  std::vector<RimPoint> points_;
  std::optional<PointTree> tree_;  // of their places
};

}  // namespace

std::vector<char> closedButForSlits(const std::vector<Eigen::Vector3d>& vertices, std::vector<BoundaryEdge> boundary,
                                    const std::vector<double>& area, const RunControl& control) {
  const std::vector<BoundaryLoop> loops = boundaryLoops(vertices.size(), std::move(boundary), control);
  if (loops.size() > kMostRims) return std::vector<char>(area.size(), 0);
  Slits slits(vertices, loops, control);
  DisjointSets joined(area.size());
  std::vector<double> open(area.size(), 0), openings, areas(area.size(), 0);
  for (std::size_t l = 0; l < loops.size(); ++l) openings.push_back(slits.area(l, fanArea(vertices, loops[l].vertices), joined));
  const auto whole = [&](std::size_t surface) { return at(joined.find(static_cast<int>(surface))); };
  for (std::size_t l = 0; l < loops.size(); ++l) open[whole(at(loops[l].surface))] += openings[l];
  for (std::size_t s = 0; s < area.size(); ++s) areas[whole(s)] += area[s];
  std::vector<char> closed;
  for (std::size_t s = 0; s < area.size(); ++s) closed.push_back(open[whole(s)] < kSmallOpening * areas[whole(s)]);
  return closed;
}

}  // namespace collision_hulls
