// The paper's decimation with the true protrusion p in place of ray concavity, and between any near clusters:
//
//   queue every pair of near nodes under a lower bound of its cost p + w * diagonal
//   while the queue holds a pair: take the cheapest
//     if a node of it was merged meanwhile: drop it
//     if its cost is only a lower bound: build the hull of both, ask the oracle, and put it back, or drop it beyond the tolerance
//     else merge: both nodes get a parent, and the parent is paired with what is near
//
// p never falls under merging, so max(p of both), and the boxes' common diagonal, bound a pair's cost from below.
#include "decompose/merging.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <tuple>

namespace collision_hulls {

namespace {

constexpr double kDiagonalWeight = 0.05;  // keeps merges small among those that protrude alike
constexpr double kNear = 2;               // hulls further apart than this, in tolerances, cannot merge within the tolerance

struct Pair {
  double cost = 0;
  int a = 0, b = 0;
  std::shared_ptr<const ConvexHull> hull;  // of both; null while the cost is only a lower bound
  double protrusion = 0;

  bool operator<(const Pair& o) const { return std::tie(cost, a, b) > std::tie(o.cost, o.a, o.b); }  // cheapest on top
};

class Merging {
 public:
  Merging(const std::vector<Leaf>& leaves, ProtrusionOracle& oracle, const std::function<void(double)>& progress)
      : oracle_(oracle), progress_(progress), leaves_(leaves.size()) {
    tree_.tolerance = oracle.tolerance();
    for (const Leaf& leaf : leaves) add({leaf.hull, leaf.protrusion, -1, -1, -1});
  }

  HullTree run(bool to_root) {
    decimate(true);
    if (to_root) decimate(false);
    return std::move(tree_);
  }

 private:
  HullNode& node(int i) { return tree_.nodes[static_cast<std::size_t>(i)]; }

  void add(const HullNode& n) {
    tree_.nodes.push_back(n);
    boxes_.push_back(boundingBox(n.hull));
  }

  void decimate(bool within_tolerance) {
    queue_ = {};
    for (int b = 0; b < static_cast<int>(tree_.nodes.size()); ++b) pairWithEarlier(b, within_tolerance);
    while (!queue_.empty()) {
      Pair pair = queue_.top();
      queue_.pop();
      if (node(pair.a).parent >= 0 || node(pair.b).parent >= 0) continue;
      if (!pair.hull)
        evaluate(std::move(pair), within_tolerance);
      else
        merge(pair, within_tolerance);
    }
  }

  void pairWithEarlier(int b, bool within_tolerance) {
    if (node(b).parent >= 0) return;
    for (int a = 0; a < b; ++a) {
      if (node(a).parent >= 0) continue;
      const double apart = boxes_[static_cast<std::size_t>(a)].exteriorDistance(boxes_[static_cast<std::size_t>(b)]);
      if (within_tolerance && apart > kNear * oracle_.tolerance()) continue;
      Pair pair;
      pair.a = a, pair.b = b;
      const Eigen::AlignedBox3d box = boxes_[static_cast<std::size_t>(a)].merged(boxes_[static_cast<std::size_t>(b)]);
      pair.cost = lowerBound(a, b) + kDiagonalWeight * box.diagonal().norm();
      queue_.push(std::move(pair));
    }
  }

  double lowerBound(int a, int b) { return std::max(node(a).protrusion, node(b).protrusion); }

  void evaluate(Pair pair, bool within_tolerance) {
    std::vector<Eigen::Vector3d> points = node(pair.a).hull.vertices;
    points.insert(points.end(), node(pair.b).hull.vertices.begin(), node(pair.b).hull.vertices.end());
    pair.hull = std::make_shared<ConvexHull>(convexHull(points));
    const double known = lowerBound(pair.a, pair.b);
    pair.protrusion = within_tolerance ? oracle_.within(*pair.hull, known) : std::max(known, oracle_.however(*pair.hull));
    if (std::isinf(pair.protrusion)) return;
    pair.cost = pair.protrusion + kDiagonalWeight * boundingBox(*pair.hull).diagonal().norm();
    queue_.push(std::move(pair));
  }

  void merge(const Pair& pair, bool within_tolerance) {
    const int parent = static_cast<int>(tree_.nodes.size());
    node(pair.a).parent = node(pair.b).parent = parent;
    add({*pair.hull, pair.protrusion, -1, pair.a, pair.b});
    pairWithEarlier(parent, within_tolerance);
    progress_(static_cast<double>(tree_.nodes.size() - leaves_) / static_cast<double>(leaves_));
  }

  ProtrusionOracle& oracle_;
  const std::function<void(double)>& progress_;
  std::size_t leaves_;
  HullTree tree_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::priority_queue<Pair> queue_;
};

}  // namespace

HullTree merged(const std::vector<Leaf>& leaves, ProtrusionOracle& oracle, bool to_root, const std::function<void(double)>& progress) {
  return Merging(leaves, oracle, progress).run(to_root);
}

std::vector<int> rootsOf(const HullTree& tree) {
  std::vector<int> roots;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    if (tree.nodes[i].parent < 0) roots.push_back(static_cast<int>(i));
  return roots;
}

}  // namespace collision_hulls
