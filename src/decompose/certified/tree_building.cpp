// A cover in, the binary tree of hulls above it out.
//
//   for tolerances that grow by a quarter from stage to stage, until one root is left:
//     merge pairs that are near, smallest union first, while the common hull very likely fits this stage's tolerance
//     each new node gets its own proven bound, raised to its children's if that is larger
//
// Bounds never fall toward the root, so a cut at any tolerance is found by walking down. Why stages: a single queue ordered by protrusion
// needs a hull and a proof for every pair in it; within a stage the size of the union, which costs nothing, is order enough. The last stage
// merges whatever is left. O(K^2) pairs a stage for K leaves, and O(K) proofs in all.
#include "decompose/certified/tree_building.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "decompose/pair_queue.h"

namespace collision_hulls {

namespace {

constexpr double kStage = 1.25;  // ratio of successive stages' tolerances
constexpr double kNearPair = 2;  // in tolerances: pairs further apart wait for a later stage
constexpr double kAmple = 2;     // in mean widths of the whole: at such a tolerance anything merges

class Building {
 public:
  Building(ProtrusionOracle& oracle, TreeBounds bounds, const std::function<void(double)>& progress)
      : oracle_(oracle), bounds_(bounds), progress_(progress) {
    tree_.tolerance = oracle.tolerance();
  }

  HullTree run(const Cover& cover) {
    for (const Group& g : cover) add(*g.hull, g.widths, boundOf(*g.hull), -1, -1);
    leaves_ = cover.size();
    const double most = ample();
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

  double ample() const {
    Widths all;
    for (const Widths& w : widths_) all = all.merged(w);
    return kAmple * all.mean();
  }

  double boundOf(const ConvexHull& hull) const {
    switch (bounds_) {
      case TreeBounds::kProved: return oracle_.bound({hull});
      case TreeBounds::kEstimated: return oracle_.estimate(hull);
      case TreeBounds::kDiagonal: break;
    }
    return boundingBox(hull).diagonal().norm();  // every hull holds some of the surface
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
    PairQueue queue;
    apart_.clear();
    const double reach = anything ? std::numeric_limits<double>::infinity() : kNearPair * tolerance;
    for (int b = 0; b < static_cast<int>(tree_.nodes.size()); ++b)
      if (isRoot(b)) pairWithEarlier(b, reach, queue);
    while (const auto pair = queue.takeCheapest([&](int i) { return isRoot(i); })) {
      std::vector<Eigen::Vector3d> points = node(pair->a).hull.vertices;
      points.insert(points.end(), node(pair->b).hull.vertices.begin(), node(pair->b).hull.vertices.end());
      const ConvexHull hull = roughHull(points, Corners::kNeeded, oracle_.control());
      if (anything || oracle_.mayFit(hull))
        pairWithEarlier(join(pair->a, pair->b, hull), reach, queue);
      else
        apart_.emplace(pair->a, pair->b);
    }
  }

  /// Pairs root b with the earlier roots whose hulls are no further away than `reach` [m].
  void pairWithEarlier(int b, double reach, PairQueue& queue) {
    for (int a = 0; a < b; ++a) {
      if (!isRoot(a) || widths(a).gap(widths(b)) > reach) continue;
      if (areApart(a, node(b).left) || areApart(a, node(b).right))
        apart_.emplace(a, b);
      else
        queue.push({widths(a).merged(widths(b)).mean(), a, b});
    }
  }

  int join(int a, int b, const ConvexHull& hull) {
    const double bound = std::max({node(a).protrusion, node(b).protrusion, boundOf(hull)});
    const int parent = add(hull, widths(a).merged(widths(b)), bound, a, b);
    progress_(static_cast<double>(tree_.nodes.size() - leaves_) / static_cast<double>(leaves_));
    return parent;
  }

  bool isRoot(int i) { return node(i).parent < 0; }
  bool areApart(int a, int b) const { return b >= 0 && apart_.count(std::minmax(a, b)) > 0; }

  ProtrusionOracle& oracle_;
  const TreeBounds bounds_;
  const std::function<void(double)>& progress_;
  HullTree tree_;
  std::vector<Widths> widths_;
  std::size_t leaves_ = 0;
  std::set<std::pair<int, int>> apart_;  // in this stage, a < b: their common hull protrudes too far, and so does any that contains it
};

}  // namespace

HullTree treeAbove(const Cover& cover, ProtrusionOracle& oracle, TreeBounds bounds, const std::function<void(double)>& progress) {
  return Building(oracle, bounds, progress).run(cover);
}

}  // namespace collision_hulls
