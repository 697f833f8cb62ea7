#include <gtest/gtest.h>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {
namespace {

LinkDescription linkWith(std::size_t visuals, std::size_t collisions) {
  LinkDescription link;
  link.visuals.resize(visuals);
  link.collisions.resize(collisions);
  return link;
}

TEST(SourceNamed, KnowsThree) {
  EXPECT_EQ(sourceNamed("auto"), Source::kAuto);
  EXPECT_EQ(sourceNamed("visual"), Source::kVisual);
  EXPECT_EQ(sourceNamed("collision"), Source::kCollision);
  EXPECT_EQ(sourceNamed("Visual"), std::nullopt);
}

TEST(SourceElements, AutoPrefersCollision) {
  EXPECT_FALSE(sourceElements(linkWith(2, 1), Source::kAuto).visual);
  EXPECT_EQ(sourceElements(linkWith(2, 1), Source::kAuto).elements.size(), 1u);
  EXPECT_TRUE(sourceElements(linkWith(2, 0), Source::kAuto).visual);
  EXPECT_EQ(sourceElements(linkWith(2, 0), Source::kAuto).elements.size(), 2u);
}

TEST(SourceElements, AsAskedFor) {
  EXPECT_TRUE(sourceElements(linkWith(2, 1), Source::kVisual).visual);
  EXPECT_EQ(sourceElements(linkWith(2, 1), Source::kVisual).elements.size(), 2u);
  EXPECT_FALSE(sourceElements(linkWith(2, 0), Source::kCollision).visual);
  EXPECT_TRUE(sourceElements(linkWith(2, 0), Source::kCollision).elements.empty());
}

}  // namespace
}  // namespace collision_hulls
