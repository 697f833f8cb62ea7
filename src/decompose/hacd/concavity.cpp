// C(S), equation (6), for unions of patches. Most triangles are dismissed by an upper bound, the height of the patch's hull over the
// triangle's plane; those left, highest first, go through the cutting planes of concavityOfTriangle() against an exact hull. Heights are
// raised when patches grow, by the other patch's box where that is enough, else by its furthest point, found in a tree. Only extreme points
// of a patch are kept, so a union costs about O(n log n) in its triangles and extreme points.
#include "decompose/hacd/concavity.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

#include "decompose/box_tree.h"
#include "decompose/hacd/triangle_concavity.h"

namespace collision_hulls {

namespace {

// More than the rounding error of a dot product with a unit vector, as a share of the coordinates.
constexpr double kRounding = 1e-14;

const Eigen::Vector3d kUnaligned = Eigen::Vector3d(0.5477, 0.6245, 0.5568).normalized();

double support(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& n) {
  return n.dot(box.center()) + n.cwiseAbs().dot(box.sizes()) / 2;
}

/// How far points reach in a direction.
class SupportFunction {
 public:
  SupportFunction(const std::vector<Eigen::Vector3d>& position, const std::vector<int>& points) {
    std::vector<Eigen::Vector3d> at;
    at.reserve(points.size());
    for (int p : points) at.push_back(position[p]);
    tree_ = BoxTree<3, 64>(at);
    coordinates_.resize(static_cast<Eigen::Index>(at.size()), 3);
    for (std::size_t i = 0; i < at.size(); ++i)
      coordinates_.row(static_cast<Eigen::Index>(i)) = at[static_cast<std::size_t>(tree_.order()[i])];
    slack_ = kRounding * (tree_.box().min().cwiseAbs() + tree_.box().max().cwiseAbs()).maxCoeff();
  }

  /// The largest n . p, where it exceeds `least`; otherwise any value up to `least`. n: a unit vector.
  double operator()(const Eigen::Vector3d& n, double least) const {
    double most = -std::numeric_limits<double>::infinity();
    const auto bound = [&](const Eigen::AlignedBox3d& box) { return -support(box, n) - slack_; };
    const auto visit = [&](std::size_t first, std::size_t last) {
      const auto block = coordinates_.middleRows(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(last - first)).array();
      most = std::max(most, (block.col(0) * n.x() + block.col(1) * n.y() + block.col(2) * n.z()).maxCoeff());
      return -std::max(most, least);
    };
    tree_.search(bound, visit, -least);
    return most;
  }

 private:
  BoxTree<3, 64> tree_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> coordinates_;  // in the tree's order, laid out for many dot products at a time
  double slack_ = 0;                                      // [m] more than their rounding error
};

std::vector<int> unionOf(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> all;
  all.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

}  // namespace

ConcavityMeasure::ConcavityMeasure(const TriangleMesh& mesh) : diagonal_(diagonal(mesh)), negligible_(kNegligible * diagonal_) {
  std::vector<int> order(mesh.vertices.size()), rank(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const double key_a = kUnaligned.dot(mesh.vertices[a]), key_b = kUnaligned.dot(mesh.vertices[b]);
    return key_a < key_b || (key_a == key_b && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = static_cast<int>(i);
    position_.push_back(mesh.vertices[order[i]]);
    key_.push_back(kUnaligned.dot(position_.back()));
  }
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    facets_.push_back({{rank[t[0]], rank[t[1]], rank[t[2]]}, normal, normal.dot(a)});
  }
}

Patch ConcavityMeasure::patch(int triangle) const {
  Patch patch;
  patch.triangles = {triangle};
  patch.heights = {0};
  const Facet& facet = facets_[triangle];
  patch.points.assign(facet.points.begin(), facet.points.end());
  std::sort(patch.points.begin(), patch.points.end());
  for (int p : patch.points) patch.box.extend(position_[p]);
  return patch;
}

std::vector<Eigen::Vector3d> ConcavityMeasure::positions(const std::vector<int>& points) const {
  std::vector<Eigen::Vector3d> result;
  result.reserve(points.size());
  for (int p : points) result.push_back(position_[p]);
  return result;
}

/// Updates the heights of triangles after `other` joins their patch. If even other's box does not rise above `floor`, the box's height
/// suffices as an upper bound.
void ConcavityMeasure::raise(std::vector<double>& heights, const std::vector<int>& triangles, const Patch& other, double floor) const {
  std::optional<SupportFunction> exact;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Facet& facet = facets_[triangles[i]];
    double rise = support(other.box, facet.normal) - facet.offset;
    if (rise > floor && rise > heights[i]) {
      if (!exact) exact.emplace(position_, other.points);
      rise = (*exact)(facet.normal, heights[i] + facet.offset) - facet.offset;
    }
    heights[i] = std::max(heights[i], rise);
  }
}

/// The triangles whose exit distance may exceed `floor`, in descending order of height.
std::vector<ConcavityMeasure::Candidate> ConcavityMeasure::candidates(const Patch& a, const Patch& b, double floor) const {
  std::vector<Candidate> result;
  const auto collect = [&](const Patch& one, const Patch& other) {
    std::vector<double> heights = one.heights;
    raise(heights, one.triangles, other, floor);
    for (std::size_t i = 0; i < heights.size(); ++i)
      if (heights[i] > floor) result.push_back({heights[i], one.triangles[i]});
  };
  collect(a, b);
  collect(b, a);
  std::sort(result.begin(), result.end(), [](const Candidate& x, const Candidate& y) {
    return x.height > y.height || (x.height == y.height && x.triangle < y.triangle);
  });
  return result;
}

ConcavityMeasure::Union ConcavityMeasure::ofUnion(const Patch& a, const Patch& b, double known, double limit) const {
  Union result{std::max({known, a.concavity, b.concavity}), {}};
  const std::vector<Candidate> open = candidates(a, b, std::max(result.value, negligible_));
  std::vector<int> points = unionOf(a.points, b.points);
  if (!open.empty()) {
    const ConvexHull hull = convexHull(positions(points));
    const ExitFaces faces(hull);
    for (const Candidate& candidate : open) {
      if (candidate.height <= std::max(result.value, negligible_)) break;
      const Facet& facet = facets_[candidate.triangle];
      const auto& p = facet.points;
      const double c = concavityOfTriangle(faces, {position_[p[0]], position_[p[1]], position_[p[2]]}, facet.normal, result.value);
      if (c > negligible_) result.value = std::max(result.value, c);
      if (result.value > limit) return result;
    }
    points = extreme(points, hull);
  }
  result.points = std::move(points);
  return result;
}

Patch ConcavityMeasure::unite(Patch a, const Patch& b, Union measured) const {
  const double floor = std::max(measured.value, negligible_);
  std::vector<double> heights = b.heights;
  raise(heights, b.triangles, a, floor);
  raise(a.heights, a.triangles, b, floor);
  a.heights.insert(a.heights.end(), heights.begin(), heights.end());
  a.triangles.insert(a.triangles.end(), b.triangles.begin(), b.triangles.end());
  a.box.extend(b.box);
  a.concavity = measured.value;
  a.points = std::move(measured.points);
  constexpr std::size_t kWorthReducing = 32;
  if (a.points.size() > 2 * std::max(a.reduced, kWorthReducing)) {
    a.points = extreme(a.points, convexHull(positions(a.points)));
    a.reduced = a.points.size();
  }
  return a;
}

/// Those of the points that are vertices of the hull. A thickened hull has its own vertices, near the outermost points.
std::vector<int> ConcavityMeasure::extreme(const std::vector<int>& points, const ConvexHull& hull) const {
  constexpr double kRounding = 1e-12;
  std::vector<int> result;
  for (const Eigen::Vector3d& v : hull.vertices) {
    const double reach = 2 * hull.thickness + kRounding * (v.cwiseAbs().maxCoeff() + diagonal_);
    const double key = kUnaligned.dot(v);
    const auto first = std::lower_bound(points.begin(), points.end(), key - reach, [&](int p, double k) { return key_[p] < k; });
    int nearest = -1;
    double least = reach * reach;
    for (auto p = first; p != points.end() && key_[*p] <= key + reach; ++p) {
      const double d = (position_[*p] - v).squaredNorm();
      if (d <= least) least = d, nearest = *p;
    }
    if (nearest < 0) return points;
    result.push_back(nearest);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace collision_hulls
