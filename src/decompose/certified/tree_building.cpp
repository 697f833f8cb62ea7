// In stages: merges within a stage's tolerance, smallest union first; then the tolerance is raised. Within a stage, merges rely on the
// oracle's quick answer; each node's bound is proven, and never less than its children's.
#include "decompose/certified/tree_building.h"

#include <algorithm>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace collision_hulls {

namespace {

constexpr double kStage = 1.25;  // ratio of successive stages' tolerances

struct Pair {
  double cost;
  int a, b;

  bool operator<(const Pair& o) const { return std::tie(cost, a, b) > std::tie(o.cost, o.a, o.b); }  // cheapest on top
};

class Building {
 public:
  Building(ProtrusionOracle& oracle, const std::function<void(double)>& progress) : oracle_(oracle), progress_(progress) {
    tree_.tolerance = oracle.tolerance();
  }

  HullTree run(const Cover& cover) {
    for (const Group& g : cover) add(*g.hull, g.widths, oracle_.bound(*g.hull), -1, -1);
    leaves_ = cover.size();
    const double most = widest();
    for (double tolerance = tree_.tolerance * kStage; !done(); tolerance *= kStage) {
      oracle_.setTolerance(tolerance);
      mergeWithin(tolerance, tolerance > most);
    }
    oracle_.setTolerance(tree_.tolerance);
    return std::move(tree_);
  }

 private:
  bool done() const { return tree_.nodes.size() == 2 * leaves_ - 1; }
  HullNode& node(int i) { return tree_.nodes[static_cast<std::size_t>(i)]; }
  const Widths& widths(int i) const { return widths_[static_cast<std::size_t>(i)]; }

  double widest() const {
    Widths all;
    for (const Widths& w : widths_) all = all.merged(w);
    return 2 * all.mean();
  }

  int add(const ConvexHull& hull, const Widths& widths, double protrusion, int left, int right) {
    const int id = static_cast<int>(tree_.nodes.size());
    tree_.nodes.push_back({hull, protrusion, -1, left, right});
    widths_.push_back(widths);
    for (const int child : {left, right})
      if (child >= 0) node(child).parent = id;
    return id;
  }

  /// `anything`: merge whatever is left, without consulting the oracle.
  void mergeWithin(double tolerance, bool anything) {
    std::priority_queue<Pair> queue;
    std::set<std::pair<int, int>> apart;  // a < b: their common hull protrudes too far, and so does any hull that contains it
    const auto areApart = [&](int a, int b) { return b >= 0 && apart.count(std::minmax(a, b)) > 0; };
    const auto pairWithEarlier = [&](int b) {
      for (int a = 0; a < b; ++a) {
        if (node(a).parent >= 0 || !(anything || widths(a).gap(widths(b)) <= 2 * tolerance)) continue;
        if (areApart(a, node(b).left) || areApart(a, node(b).right))
          apart.emplace(a, b);
        else
          queue.push({widths(a).merged(widths(b)).mean(), a, b});
      }
    };
    for (int b = 0; b < static_cast<int>(tree_.nodes.size()); ++b)
      if (node(b).parent < 0) pairWithEarlier(b);
    while (!queue.empty()) {
      const Pair pair = queue.top();
      queue.pop();
      if (node(pair.a).parent >= 0 || node(pair.b).parent >= 0) continue;
      std::vector<Eigen::Vector3d> points = node(pair.a).hull.vertices;
      points.insert(points.end(), node(pair.b).hull.vertices.begin(), node(pair.b).hull.vertices.end());
      const ConvexHull hull = roughHull(points);
      if (!anything && !oracle_.mayFit(hull)) {
        apart.emplace(pair.a, pair.b);
        continue;
      }
      const double bound = std::max({node(pair.a).protrusion, node(pair.b).protrusion, oracle_.bound(hull)});
      const int parent = add(hull, widths(pair.a).merged(widths(pair.b)), bound, pair.a, pair.b);
      progress_(static_cast<double>(tree_.nodes.size() - leaves_) / static_cast<double>(leaves_));
      pairWithEarlier(parent);
    }
  }

  ProtrusionOracle& oracle_;
  const std::function<void(double)>& progress_;
  HullTree tree_;
  std::vector<Widths> widths_;
  std::size_t leaves_ = 0;
};

}  // namespace

HullTree treeAbove(const Cover& cover, ProtrusionOracle& oracle, const std::function<void(double)>& progress) {
  return Building(oracle, progress).run(cover);
}

}  // namespace collision_hulls
