#include "query/box_groups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/random_stream.h"

namespace collision_hulls {
namespace {

std::vector<Eigen::AlignedBox3d> randomBoxes(std::size_t count, std::uint64_t seed) {
  Random random(seed, 0, 0);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    boxes.emplace_back(at, at + random.uniform(0, 0.2) * Eigen::Vector3d::Ones());
  }
  return boxes;
}

TEST(BoxGroups, VisitsAllThatMeetABoxAndNoOthers) {
  for (const std::size_t count : {0, 1, 2, 3, 10, 500}) {
    const std::vector<Eigen::AlignedBox3d> boxes = randomBoxes(count, 1);
    const BoxGroups groups(boxes);
    for (const Eigen::AlignedBox3d& box : randomBoxes(50, 2)) {
      std::multiset<std::size_t> expected, found;
      for (std::size_t i = 0; i < count; ++i)
        if (boxes[i].intersects(box)) expected.insert(i);
      EXPECT_FALSE(groups.visitMeeting(box, [&](std::size_t i) {
        found.insert(i);
        return false;
      }));
      EXPECT_EQ(found, expected);
      int visits = 0;
      EXPECT_EQ(groups.visitMeeting(box, [&](std::size_t) { return ++visits == 1; }), !expected.empty());
      EXPECT_LE(visits, 1) << "the first was enough";
    }
  }
}

TEST(BoxGroups, AreFewAndOfNeighbours) {
  const std::vector<Eigen::AlignedBox3d> boxes = randomBoxes(400, 1);
  const BoxGroups groups(boxes);
  EXPECT_EQ(groups.count(), 20u);
  std::set<std::size_t> all;
  double volume = 0;
  for (std::size_t g = 0; g < groups.count(); ++g) {
    volume += groups.box(g).volume();
    for (const BoxGroups::Member* member = groups.begin(g); member != groups.end(g); ++member) {
      EXPECT_TRUE(groups.box(g).contains(member->box));
      EXPECT_TRUE(member->box.isApprox(boxes[member->index]));
      all.insert(member->index);
    }
  }
  EXPECT_EQ(all.size(), 400u);
  EXPECT_LT(volume, 20) << "of 8 m^3, which any twenty random members would nearly fill";
}

}  // namespace
}  // namespace collision_hulls
