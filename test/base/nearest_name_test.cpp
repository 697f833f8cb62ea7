#include "base/nearest_name.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(EditDistance, KnownOnes) {
  EXPECT_EQ(editDistance("", ""), 0u);
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance("abc", ""), 3u);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(EditDistance, SwappedNeighboursAreOneEdit) {
  EXPECT_EQ(editDistance("ab", "ba"), 1u);
  EXPECT_EQ(editDistance("heigth", "height"), 1u);
  EXPECT_EQ(editDistance("lenght", "length"), 1u);
  EXPECT_EQ(editDistance("abcd", "badc"), 2u);
  EXPECT_EQ(editDistance("ca", "abc"), 3u) << "no letter is edited twice";
  EXPECT_EQ(editDistance("aab", "aba"), 1u);
  EXPECT_EQ(editDistance("abc", "cba"), 2u) << "not neighbours";
}

TEST(NearestName, TheOneThatWasMeant) {
  const std::vector<std::string> names{"tolerance", "tree", "links", "source"};
  EXPECT_EQ(nearestName("tolerence", names), "tolerance");
  EXPECT_EQ(nearestName("tol", names), "tolerance") << "its beginning";
  EXPECT_EQ(nearestName("link", names), "links");
  EXPECT_EQ(nearestName("fine", names), "");
  EXPECT_EQ(nearestName("", names), "");
  EXPECT_EQ(nearestName("t", names), "");
  EXPECT_EQ(nearestName("ab", {"cd"}), "") << "nothing in common";
  EXPECT_EQ(nearestName("tolerance", {}), "");
  EXPECT_EQ(nearestName("tolerances", names), "tolerance");
  EXPECT_EQ(nearestName("heigth", {"eighth", "height"}), "height") << "swapped letters are nearer than others";
  const std::string endless(10'000'000, 'x');  // to be compared letter by letter, it would take hours
  EXPECT_EQ(nearestName(endless, {endless + "y"}), "");
  EXPECT_EQ(nearestName("tolerence", {endless, "tolerance"}), "tolerance");
  const std::string long_name(1000, 'x');  // with tens of thousands of names, it would take minutes
  EXPECT_EQ(nearestName(long_name + "y", {long_name}), "");
}

TEST(DidYouMean, AQuestionOrNothing) {
  EXPECT_EQ(didYouMean("certifed", {"certified", "hacd"}), "; did you mean 'certified'?");
  EXPECT_EQ(didYouMean("vhacdplusplus", {"certified", "hacd"}), "");
}

}  // namespace
}  // namespace collision_hulls
