// Boxes in groups of neighbours, for what is compared with thousands of boxes again and again.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace collision_hulls {

/// n boxes in about sqrt(n) groups, each with a box around it.
class BoxGroups {
 public:
  BoxGroups() = default;
  explicit BoxGroups(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// One of the boxes.
  struct Member {
    Eigen::AlignedBox3d box;
    std::size_t index;  // among those that were given
  };

  std::size_t count() const { return groups_.size(); }
  const Eigen::AlignedBox3d& box(std::size_t group) const { return groups_[group]; }
  const Member* begin(std::size_t group) const { return members_.data() + group * size_; }
  const Member* end(std::size_t group) const { return members_.data() + std::min(members_.size(), (group + 1) * size_); }

  /// Calls `visit` with the index of each box that meets this one, until it returns true; whether it did.
  template <typename Visit>
  bool visitMeeting(const Eigen::AlignedBox3d& box, const Visit& visit) const {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (!groups_[g].intersects(box)) continue;
      for (const Member* member = begin(g); member != end(g); ++member)
        if (member->box.intersects(box) && visit(member->index)) return true;
    }
    return false;
  }

 private:
  std::size_t size_ = 1;         // members of a group, but for the last
  std::vector<Member> members_;  // group by group
  std::vector<Eigen::AlignedBox3d> groups_;
};

}  // namespace collision_hulls
