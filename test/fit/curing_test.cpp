#include "fit/curing.h"

#include <gtest/gtest.h>

#include "fit/fit_fixtures.h"

namespace collision_hulls {
namespace {

using namespace fit_fixtures;

/// Two channels and a post are pieces 0, 1 and 2. `interlocked` is the pose of the second channel in the first one's frame: turned by half
/// a turn, with a wall of each in the other's gap and nothing in contact.
class TwoChannels : public ::testing::Test {
 protected:
  TwoChannels() {
    problem_.robot = carriages(2);
    for (std::size_t link = 1; link <= 2; ++link) problem_.elements.push_back({"", link, Eigen::Isometry3d::Identity(), channelMesh()});
    problem_.scene.bodies.push_back(boxBody("post", {0.1, 0.1, 0.1}, gap()));
    assembly_ = std::make_unique<Assembly>(problem_, 1);
    interlocked_ = Eigen::Translation3d(0.5, 0.45, 0) * Eigen::AngleAxisd(EIGEN_PI, Eigen::Vector3d::UnitZ());
  }

  int root(int piece) const { return assembly_->pieces()[static_cast<std::size_t>(piece)].tree->root(); }
  Contact contact(int first, int second, const Eigen::Isometry3d& pose) const {
    return {0, {first, second}, {root(first), root(second)}, pose};
  }
  Contact withPost(int channel) const { return contact(channel, 2, Eigen::Isometry3d(Eigen::Translation3d(gap()))); }
  bool stillTouch(const Cuts& cuts, const Contact& at) const {
    for (const int first : cuts[static_cast<std::size_t>(at.piece[0])])
      for (const int second : cuts[static_cast<std::size_t>(at.piece[1])])
        if (touches(*assembly_, at, first, second)) return true;
    return false;
  }
  Cuts cured(const std::vector<Contact>& contacts) {
    Curing curing(*assembly_, assembly_->roots());
    curing.add(contacts);
    curing.run({});
    for (const Contact& at : contacts) EXPECT_FALSE(stillTouch(curing.cuts(), at));
    return curing.cuts();
  }
  bool isCut(const Cuts& cuts, int piece) const { return channelMesh()->tree.isCut(cuts[static_cast<std::size_t>(piece)]); }

  FitProblem problem_;
  std::unique_ptr<Assembly> assembly_;
  Eigen::Isometry3d interlocked_;
};

TEST_F(TwoChannels, NothingToCure) {
  EXPECT_EQ(cured({}), assembly_->roots());
}

TEST_F(TwoChannels, OnlyTheSideThatCuresIsOpened) {
  const Cuts cuts = cured({withPost(0)});
  EXPECT_EQ(cuts[0].size(), 3u);
  EXPECT_TRUE(isCut(cuts, 0));
  EXPECT_EQ(cuts[1].size(), 1u);
}

TEST_F(TwoChannels, OpensBothSidesIfOneAloneDoesNotCure) {
  const Contact both = contact(0, 1, interlocked_);
  ASSERT_TRUE(touches(*assembly_, both, root(0), root(1)));
  ASSERT_FALSE(touchesAtLeaves(*assembly_, both));
  const Cuts cuts = cured({both});
  EXPECT_GT(cuts[0].size(), 1u);
  EXPECT_GT(cuts[1].size(), 1u);
  EXPECT_TRUE(isCut(cuts, 0) && isCut(cuts, 1));
}

TEST_F(TwoChannels, ContactsFollowNodesOpenedForOthers) {
  // The posts open the second channel first, for which the contact between the channels has no vote yet.
  const Cuts cuts = cured({contact(0, 1, interlocked_), withPost(1), withPost(1), withPost(1)});
  EXPECT_TRUE(isCut(cuts, 0) && isCut(cuts, 1));
}

TEST_F(TwoChannels, KeepsAContactBetweenLeaves) {
  const Contact in_wall = contact(0, 2, Eigen::Isometry3d::Identity());
  EXPECT_TRUE(touchesAtLeaves(*assembly_, in_wall));
  Curing curing(*assembly_, assembly_->roots());
  curing.add({in_wall});
  curing.run({});
  EXPECT_TRUE(stillTouch(curing.cuts(), in_wall));
}

TEST_F(TwoChannels, ClosesNodesThatNoContactNeedsOpen) {
  Cuts finest = assembly_->roots();
  for (std::size_t i = 0; i < 2; ++i) finest[i] = channelMesh()->tree.cutAt(0);
  EXPECT_EQ(closed(*assembly_, finest, {}, {}), assembly_->roots());
  const Cuts kept = closed(*assembly_, finest, {withPost(0)}, {});
  EXPECT_EQ(kept[0].size(), 3u);
  EXPECT_EQ(kept[1].size(), 1u);
}

}  // namespace
}  // namespace collision_hulls
