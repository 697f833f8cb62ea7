// A balanced k-d tree as an implicit binary heap: each node halves its points at the median of its box's longest side.
#include "geometry/point_tree.h"

#include <algorithm>
#include <numeric>

namespace collision_hulls {

namespace {

constexpr std::size_t kFew = 16;  // points at which a node is not split further

}  // namespace

struct PointTree::Search {
  const Eigen::Vector3d& p;
  double square;  // of the distance to beat
  std::size_t left;
  const std::function<bool(std::size_t)>& accepts;
  std::optional<std::size_t> found;
};

PointTree::PointTree(std::vector<Eigen::Vector3d> points) : order_(points.size()), points_(std::move(points)) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  build(0, 0, points_.size());
  std::vector<Eigen::Vector3d> in_order;
  in_order.reserve(points_.size());
  for (const std::size_t i : order_) in_order.push_back(points_[i]);
  points_ = std::move(in_order);
}

void PointTree::build(std::size_t node, std::size_t first, std::size_t last) {
  if (node >= boxes_.size()) boxes_.resize(2 * node + 1);
  Eigen::AlignedBox3d& box = boxes_[node];
  for (std::size_t i = first; i < last; ++i) box.extend(points_[order_[i]]);
  if (last - first <= kFew) return;
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::size_t a, std::size_t b) { return points_[a][axis] < points_[b][axis]; });
  build(2 * node + 1, first, middle);
  build(2 * node + 2, middle, last);
}

bool PointTree::anyBeyond(std::size_t node, std::size_t first, std::size_t last, const HalfSpace& plane, double margin) const {
  const Eigen::AlignedBox3d& box = boxes_[node];
  const double reach = plane.normal.cwiseAbs().dot(box.sizes() / 2);
  if (!(plane.distance(box.center()) + reach > margin)) return false;
  if (last - first <= kFew)
    return std::any_of(points_.begin() + static_cast<std::ptrdiff_t>(first), points_.begin() + static_cast<std::ptrdiff_t>(last),
                       [&](const Eigen::Vector3d& p) { return plane.distance(p) > margin; });
  const std::size_t middle = first + (last - first) / 2;
  return anyBeyond(2 * node + 1, first, middle, plane, margin) || anyBeyond(2 * node + 2, middle, last, plane, margin);
}

std::optional<std::size_t> PointTree::nearest(const Eigen::Vector3d& p, double limit, std::size_t most,
                                              const std::function<bool(std::size_t)>& accepts) const {
  Search search{p, limit * limit, most, accepts, std::nullopt};
  if (!points_.empty()) nearest(0, 0, points_.size(), search);
  return search.found;
}

void PointTree::nearest(std::size_t node, std::size_t first, std::size_t last, Search& search) const {
  if (search.left == 0 || !(boxes_[node].squaredExteriorDistance(search.p) < search.square)) return;
  if (last - first > kFew) {
    const std::size_t middle = first + (last - first) / 2, below = 2 * node + 1, above = 2 * node + 2;
    const bool below_first = boxes_[below].squaredExteriorDistance(search.p) <= boxes_[above].squaredExteriorDistance(search.p);
    if (below_first) nearest(below, first, middle, search);
    nearest(above, middle, last, search);
    if (!below_first) nearest(below, first, middle, search);
    return;
  }
  for (std::size_t i = first; i < last && search.left > 0; ++i) {
    const double square = (points_[i] - search.p).squaredNorm();
    if (!(square < search.square)) continue;
    --search.left;
    if (search.accepts(order_[i])) search.square = square, search.found = order_[i];
  }
}

}  // namespace collision_hulls
