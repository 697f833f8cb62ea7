// A balanced tree of boxes over points of any dimension, for branch and bound: minima over large
// sets that few boxes decide.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace collision_hulls {

/// Each node halves its items at the median of its box's longest side, down to leaves of up to
/// kLeaf items.
template <int kDimension, std::size_t kLeaf>
class BoxTree {
 public:
  using Key = Eigen::Matrix<double, kDimension, 1>;
  using Box = Eigen::AlignedBox<double, kDimension>;

  BoxTree() = default;
  explicit BoxTree(const std::vector<Key>& keys) : order_(keys.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!keys.empty()) build(keys, 0, 0, keys.size());
  }

  /// The indices of the keys, leaf by leaf.
  const std::vector<int>& order() const { return order_; }

  const Box& box() const { return boxes_[0]; }  ///< of all items; there must be one

  /// Calls visit(first, last) for leaves, order()[first, last), always in the same sequence. It
  /// returns the least value so far; what lies in boxes whose bound(box) exceeds that value is left
  /// out.
  template <class Bound, class Visit>
  void search(const Bound& bound, const Visit& visit, double least) const {
    if (!order_.empty()) search(0, 0, order_.size(), bound(boxes_[0]), bound, visit, least);
  }

 private:
  // The children of node i are 2 i + 1 and 2 i + 2.
  void build(const std::vector<Key>& keys, std::size_t node, std::size_t first, std::size_t last) {
    if (node >= boxes_.size()) boxes_.resize(2 * node + 1);
    Box box;
    for (std::size_t i = first; i < last; ++i) box.extend(keys[static_cast<std::size_t>(order_[i])]);
    boxes_[node] = box;
    if (last - first <= kLeaf) return;
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](int a, int b) { return keys[static_cast<std::size_t>(a)][axis] < keys[static_cast<std::size_t>(b)][axis]; });
    build(keys, 2 * node + 1, first, middle);
    build(keys, 2 * node + 2, middle, last);
  }

  template <class Bound, class Visit>
  void search(std::size_t node, std::size_t first, std::size_t last, double here, const Bound& bound, const Visit& visit,
              double& least) const {
    if (here > least) return;
    if (last - first <= kLeaf) {
      least = visit(first, last);
      return;
    }
    const std::size_t middle = first + (last - first) / 2, left = 2 * node + 1, right = left + 1;
    const double at_left = bound(boxes_[left]), at_right = bound(boxes_[right]);
    const auto goLeft = [&] { search(left, first, middle, at_left, bound, visit, least); };
    const auto goRight = [&] { search(right, middle, last, at_right, bound, visit, least); };
    if (at_left <= at_right)
      goLeft(), goRight();
    else
      goRight(), goLeft();
  }

  std::vector<int> order_;
  std::vector<Box, Eigen::aligned_allocator<Box>> boxes_;
};

}  // namespace collision_hulls
