// Merging needs a bound for each merged hull M, and a page must not cost what a decomposition costs. Instead of the distance from M to the
// solid, this bounds the distance from M to the hulls that M was merged from. They are within `bound` of the solid, so M is within the sum.
//
// The distance to one convex hull is a convex function: over a tetrahedron it is largest at a corner. So the distance to the nearest of
// several hulls is, over a tetrahedron, at most the least over the hulls of the largest at the four corners. M is cut into tetrahedra from
// its middle, and the one with the largest bound is halved until that bound is nearly reached at a corner, or until the budget is spent;
// what is left over is a bound all the same. Two parts cost about a millisecond.
//
// Against many parts that would cost too much: then the parts are the two hulls that were merged, and their own bounds count in full. The
// order of merging is greedy by a cheap estimate, from how far each hull's vertices lie beyond the other's planes.
#include "decompose/coarser/coarser_hulls.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>

#include "decompose/pair_queue.h"
#include "geometry/hull_support.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostParts = 6;          // that a merged hull is compared with
constexpr std::size_t kMostDistances = 1000;   // computed for a merged hull, beyond those of its vertices
constexpr double kGap = 0.03;                  // of the distance: a bound this close is close enough
constexpr double kCoordinateRounding = 1e-12;  // of the coordinates

/// A cell's corners (indices), and what no point in it exceeds.
struct Cell {
  double most = 0;
  std::array<int, 4> corners{};
  bool operator<(const Cell& other) const { return most < other.most; }
};

/// The search for the point of a hull that is furthest from all parts.
class Search {
 public:
  explicit Search(const std::vector<const ConvexHull*>& parts) : parts_(parts) {}

  double furthest(const ConvexHull& hull) {
    start(hull);
    const std::size_t last = gaps_.size() + kMostDistances;
    while (cells_.top().most > (1 + kGap) * found_ && gaps_.size() < last) halve();
    return cells_.top().most;
  }

 private:
  /// Tetrahedra from the middle of the hull to its triangles.
  void start(const ConvexHull& hull) {
    for (const Eigen::Vector3d& vertex : hull.vertices) addCorner(vertex);
    const int centre = addCorner(meanOfVertices(hull));
    for (const Triangle& t : hull.triangles) addCell({t[0], t[1], t[2], centre});
  }

  int addCorner(const Eigen::Vector3d& place) {
    double least = std::numeric_limits<double>::infinity();
    for (const ConvexHull* part : parts_) {
      gaps_.push_back(distance(*part, place));
      least = std::min(least, gaps_.back());
    }
    found_ = std::max(found_, least);
    corners_.push_back(place);
    return static_cast<int>(corners_.size()) - 1;
  }

  void addCell(const std::array<int, 4>& corners) {
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      double of_part = 0;
      for (const int corner : corners) of_part = std::max(of_part, gaps_[static_cast<std::size_t>(corner) * parts_.size() + part]);
      most = std::min(most, of_part);
    }
    cells_.push({most, corners});
  }

  const Eigen::Vector3d& place(int corner) const { return corners_[static_cast<std::size_t>(corner)]; }

  /// Halves the cell with the largest bound across its longest edge.
  void halve() {
    const Cell cell = cells_.top();
    cells_.pop();
    std::size_t a = 0, b = 1;
    const auto length = [&](std::size_t i, std::size_t j) { return (place(cell.corners[i]) - place(cell.corners[j])).squaredNorm(); };
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j)
        if (length(i, j) > length(a, b)) a = i, b = j;
    }
    const int middle = addCorner((place(cell.corners[a]) + place(cell.corners[b])) / 2);
    for (const std::size_t end : {a, b}) {
      std::array<int, 4> half = cell.corners;
      half[end] = middle;
      addCell(half);
    }
  }

  const std::vector<const ConvexHull*>& parts_;
  std::vector<Eigen::Vector3d> corners_;
  std::vector<double> gaps_;  // of each corner from each part
  std::priority_queue<Cell> cells_;
  double found_ = 0;
};

double extentOf(const ConvexHull& hull) {
  const Eigen::AlignedBox3d box = boundingBox(hull);
  return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// [m] How far the vertices of one hull lie beyond the other's planes.
double beyond(const ConvexHull& one, const ConvexHull& other) {
  double most = 0;
  for (const Eigen::Vector3d& vertex : one.vertices) most = std::max(most, planeDistance(other, vertex));
  return most;
}

/// About what merging adds: halfway between two points the distance to either end is what the shorter way allows.
double estimate(const ConvexHull& a, const ConvexHull& b) {
  const double from_a = beyond(a, b), from_b = beyond(b, a);
  return from_a + from_b > 0 ? from_a * from_b / (from_a + from_b) : 0;
}

ConvexHull merged(const ConvexHull& a, const ConvexHull& b, const RunControl& control) {
  std::vector<Eigen::Vector3d> points = a.vertices;
  points.insert(points.end(), b.vertices.begin(), b.vertices.end());
  return convexHull(points, control);
}

/// Grows a tree, node by node.
class Merging {
 public:
  Merging(const std::vector<ConvexHull>& hulls, double bound) {
    tree_.tolerance = bound;
    for (const ConvexHull& hull : hulls) add({hull, bound, -1, -1, -1}, {static_cast<int>(tree_.nodes.size())});
  }

  HullTree run(const RunControl& control) {
    while (const auto pair = queue_.takeCheapest([&](int node) { return at(node).parent < 0; })) {
      control.check();
      merge(pair->a, pair->b, control);
    }
    return std::move(tree_);
  }

 private:
  HullNode& at(int node) { return tree_.nodes[static_cast<std::size_t>(node)]; }

  void add(HullNode node, std::vector<int> leaves) {
    const int id = static_cast<int>(tree_.nodes.size());
    for (int other = 0; other < id; ++other)
      if (at(other).parent < 0) queue_.push({estimate(node.hull, at(other).hull), other, id});
    tree_.nodes.push_back(std::move(node));
    leaves_.push_back(std::move(leaves));
  }

  void merge(int a, int b, const RunControl& control) {
    HullNode node{merged(at(a).hull, at(b).hull, control), std::max(at(a).protrusion, at(b).protrusion), -1, a, b};
    std::vector<int> leaves = leaves_[static_cast<std::size_t>(a)];
    leaves.insert(leaves.end(), leaves_[static_cast<std::size_t>(b)].begin(), leaves_[static_cast<std::size_t>(b)].end());
    const bool few = leaves.size() <= kMostParts;
    const std::vector<int> nodes = few ? leaves : std::vector<int>{a, b};
    std::vector<const ConvexHull*> parts;
    for (const int part : nodes) parts.push_back(&at(part).hull);
    node.protrusion = std::max(node.protrusion, (few ? tree_.tolerance : node.protrusion) + furthestFrom(parts, node.hull));
    at(a).parent = at(b).parent = static_cast<int>(tree_.nodes.size());
    add(std::move(node), std::move(leaves));
  }

  HullTree tree_;
  std::vector<std::vector<int>> leaves_;  // below each node
  PairQueue queue_;
};

}  // namespace

double furthestFrom(const std::vector<const ConvexHull*>& parts, const ConvexHull& hull) {
  double rounding = hull.slack + kCoordinateRounding * extentOf(hull);
  for (const ConvexHull* part : parts) rounding = std::max(rounding, part->slack + kCoordinateRounding * extentOf(hull));
  return Search(parts).furthest(hull) + rounding;
}

HullTree coarserHulls(const std::vector<ConvexHull>& hulls, double bound, const RunControl& control) {
  return Merging(hulls, bound).run(control);
}

}  // namespace collision_hulls
