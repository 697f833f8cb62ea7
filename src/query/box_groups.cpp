// Halves the boxes across the longest axis of their centres until a group is left.
#include "query/box_groups.h"

#include <cmath>

namespace collision_hulls {
namespace {

using Members = std::vector<BoxGroups::Member>;

/// Sorts so that each run of `size` members is a group of neighbours in space.
void sortIntoGroups(std::size_t size, Members::iterator first, Members::iterator last) {
  const auto count = static_cast<std::size_t>(last - first);
  if (count <= size) return;
  Eigen::AlignedBox3d all;
  std::for_each(first, last, [&](const BoxGroups::Member& member) { all.extend(member.box.center()); });
  Eigen::Index axis;
  all.sizes().maxCoeff(&axis);
  const std::size_t groups = (count + size - 1) / size;
  const auto middle = first + static_cast<std::ptrdiff_t>(groups / 2 * size);
  std::nth_element(first, middle, last,
                   [&](const BoxGroups::Member& a, const BoxGroups::Member& b) { return a.box.center()[axis] < b.box.center()[axis]; });
  sortIntoGroups(size, first, middle);
  sortIntoGroups(size, middle, last);
}

}  // namespace

BoxGroups::BoxGroups(const std::vector<Eigen::AlignedBox3d>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) members_.push_back({boxes[i], i});
  // As many groups as each has members.
  size_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(std::max(boxes.size(), std::size_t{1})))));
  sortIntoGroups(size_, members_.begin(), members_.end());
  groups_.resize((members_.size() + size_ - 1) / size_);
  for (std::size_t g = 0; g < groups_.size(); ++g)
    for (const Member* member = begin(g); member != end(g); ++member) groups_[g].extend(member->box);
}

}  // namespace collision_hulls
