// A balanced k-d tree as an implicit binary heap: each node halves its points at the median of its box's longest side.
#include "geometry/point_tree.h"

#include <algorithm>

namespace collision_hulls {

namespace {

constexpr std::size_t kFew = 16;  // points at which a node is not split further

}  // namespace

PointTree::PointTree(std::vector<Eigen::Vector3d> points) : points_(std::move(points)) {
  build(0, 0, points_.size());
}

void PointTree::build(std::size_t node, std::size_t first, std::size_t last) {
  if (node >= boxes_.size()) boxes_.resize(2 * node + 1);
  Eigen::AlignedBox3d& box = boxes_[node];
  for (std::size_t i = first; i < last; ++i) box.extend(points_[i]);
  if (last - first <= kFew) return;
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
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

}  // namespace collision_hulls
