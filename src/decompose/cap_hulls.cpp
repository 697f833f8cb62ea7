// Greedy merging with a lazy priority queue: a pair enters with a lower bound of its cost and gets its exact cost, which takes a hull, only
// when it comes out on top.
#include "decompose/cap_hulls.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "decompose/pair_queue.h"

namespace collision_hulls {

namespace {

constexpr double kDiagonalShare = 0.05;  // weight of the union's diagonal in a pair's cost
constexpr std::size_t kNeighbours = 8;   // nearest boxes considered for merging, per hull

/// A hull, or a union of hulls.
struct Body {
  ConvexHull hull;
  double volume = 0;
  Eigen::AlignedBox3d box;
  int first = 0;  // least index of the hulls in it
  bool merged = false;
};

ConvexHull hullOfBoth(const ConvexHull& a, const ConvexHull& b, const RunControl& control) {
  std::vector<Eigen::Vector3d> points = a.vertices;
  points.insert(points.end(), b.vertices.begin(), b.vertices.end());
  ConvexHull hull = convexHull(points, control);
  hull.thickness = std::max({hull.thickness, a.thickness, b.thickness});
  return hull;
}

class Merging {
 public:
  Merging(const std::vector<ConvexHull>& hulls, const RunControl& control) : control_(control) {
    for (const ConvexHull& hull : hulls) add(hull, static_cast<int>(bodies_.size()));
  }

  void mergeDownTo(std::size_t count) {
    for (std::size_t left = bodies_.size(); left > count; --left) {
      const MergePair pair = cheapest();
      Body &a = bodies_[pair.a], &b = bodies_[pair.b];
      a.merged = b.merged = true;
      add(hullOfBoth(a.hull, b.hull, control_), std::min(a.first, b.first));
    }
  }

  std::vector<ConvexHull> hulls() {
    bodies_.erase(std::remove_if(bodies_.begin(), bodies_.end(), [](const Body& body) { return body.merged; }), bodies_.end());
    std::sort(bodies_.begin(), bodies_.end(), [](const Body& a, const Body& b) { return a.first < b.first; });
    std::vector<ConvexHull> result;
    for (Body& body : bodies_) result.push_back(std::move(body.hull));
    return result;
  }

 private:
  double leastCost(const Body& a, const Body& b) const { return kDiagonalShare * a.box.merged(b.box).diagonal().norm(); }

  /// Adds a body and its pairs with the bodies that have the nearest boxes.
  void add(ConvexHull hull, int first) {
    control_.check();
    const int index = static_cast<int>(bodies_.size());
    Body body{std::move(hull), 0, {}, first, false};
    body.volume = volume(body.hull);
    body.box = boundingBox(body.hull);
    std::vector<std::tuple<double, double, int>> near;
    for (int k = 0; k < index; ++k)
      if (!bodies_[k].merged) near.emplace_back(bodies_[k].box.squaredExteriorDistance(body.box), leastCost(bodies_[k], body), k);
    const auto end = near.begin() + static_cast<std::ptrdiff_t>(std::min(kNeighbours, near.size()));
    std::partial_sort(near.begin(), end, near.end());
    for (auto n = near.begin(); n != end; ++n) queue_.push({std::get<1>(*n), std::get<2>(*n), index, false});
    bodies_.push_back(std::move(body));
  }

  /// The cheapest pair of unmerged bodies, with its exact cost.
  MergePair cheapest() {
    for (;;) {
      control_.check();
      MergePair pair = *queue_.takeCheapest([&](int i) { return !bodies_[i].merged; });
      if (pair.is_exact) return pair;
      const Body &a = bodies_[pair.a], &b = bodies_[pair.b];
      pair.cost += std::cbrt(std::max(0.0, volume(hullOfBoth(a.hull, b.hull, control_)) - a.volume - b.volume));
      pair.is_exact = true;
      queue_.push(pair);
    }
  }

  const RunControl& control_;
  std::vector<Body> bodies_;
  PairQueue queue_;
};

}  // namespace

std::vector<ConvexHull> capHulls(const std::vector<ConvexHull>& hulls, int max_hulls, const RunControl& control) {
  if (hulls.size() <= static_cast<std::size_t>(max_hulls)) return hulls;
  Merging merging(hulls, control);
  merging.mergeDownTo(static_cast<std::size_t>(max_hulls));
  return merging.hulls();
}

}  // namespace collision_hulls
