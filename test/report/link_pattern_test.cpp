#include "report/link_pattern.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

TEST(LinkPattern, MatchesWholeNames) {
  const LinkPattern pattern("(left|right)_finger[0-9]{1,2}", "links");
  EXPECT_TRUE(pattern.matches("left_finger7"));
  EXPECT_TRUE(pattern.matches("right_finger12"));
  EXPECT_FALSE(pattern.matches("left_finger"));
  EXPECT_FALSE(pattern.matches("my_left_finger7"));
  EXPECT_TRUE(LinkPattern("(?!camera).*", "links").matches("arm"));
  EXPECT_FALSE(LinkPattern("(?!camera).*", "links").matches("camera_1"));
}

// Where every way is tried on its own, each of these takes longer than the universe is old, or overflows the stack.
TEST(LinkPattern, HostileExpressionsEnd) {
  const std::string name(200, 'a');
  EXPECT_FALSE(LinkPattern("(a*)*b", "links").matches(name));
  EXPECT_FALSE(LinkPattern("(a|a)*b", "links").matches(name));
  EXPECT_FALSE(LinkPattern("(a|aa)+b", "links").matches(name));
  EXPECT_TRUE(LinkPattern(".*", "links").matches(std::string(1'000'000, 'a')));
}

TEST(LinkPattern, ManyNames) {
  std::string names;
  for (int i = 0; i < 2000; ++i) names += (i ? "|" : "") + std::string("my_robot_link_") + std::to_string(i);
  EXPECT_TRUE(LinkPattern(names, "links").matches("my_robot_link_1999"));
  EXPECT_FALSE(LinkPattern(names, "links").matches("my_robot_link_2000"));
}

TEST(LinkPattern, RefusesWhatIsNoExpression) {
  for (const char* expression : {"(", "a{2", "[z-a]", "*", "(a)\\1", "(a?){99999}"}) {
    try {
      const LinkPattern pattern(expression, "links");
      ADD_FAILURE() << expression;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      EXPECT_EQ(std::string(error.what()).find("links '" + std::string(expression) + "' is invalid"), 0u) << error.what();
    }
  }
  EXPECT_THROW(LinkPattern(std::string(50'001, 'a'), "links"), Error);
  EXPECT_THROW(LinkPattern(std::string(20'000, '(') + "a" + std::string(20'000, ')'), "links"), Error)
      << "its compiler would overflow the stack";
}

}  // namespace
}  // namespace collision_hulls
