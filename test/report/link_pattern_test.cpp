#include "report/link_pattern.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

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

TEST(LinkPattern, AStarAsInAShell) {
  EXPECT_EQ(didYouMeanAny("wrist_*"), "; did you mean 'wrist_.*'?");
  EXPECT_EQ(didYouMeanAny("*_finger|arm*"), "; did you mean '.*_finger|arm.*'?");
  for (const char* meant : {"", "arm", "wrist_.*", "(left|right)*", "[a-z]*", "[*]", "\\w*", "wrist_\\*", "arm\\"})
    EXPECT_EQ(didYouMeanAny(meant), "") << meant;
  try {
    LinkPattern("*_finger", "links");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("back-references); did you mean '.*_finger'?"), std::string::npos) << error.what();
  }
}

// Where every way is tried on its own, each of these takes longer than the universe is old, or overflows the stack.
TEST(LinkPattern, HostileExpressionsEnd) {
  const std::string name(200, 'a');
  EXPECT_FALSE(LinkPattern("(a*)*b", "links").matches(name));
  EXPECT_FALSE(LinkPattern("(a|a)*b", "links").matches(name));
  EXPECT_FALSE(LinkPattern("(a|aa)+b", "links").matches(name));
  EXPECT_TRUE(LinkPattern(".*", "links").matches(std::string(1'000'000, 'a')));
}

// A look-ahead in a repeated group reads the name once for each place, and those within it once for each of these.
TEST(LinkPattern, HostileLookAheadsAreRefused) {
  const LinkPattern hostile("((?=((?=((?=x*y|).)*y|).)*y|).)*", "only");
  EXPECT_TRUE(hostile.matches("xxxxx"));
  try {
    hostile.matches(std::string(1000, 'x'));
    ADD_FAILURE() << "matched";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    for (const char* part : {"only '((?=", "looks ahead too often", "'xxx", "look ahead at the beginning alone"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  EXPECT_TRUE(LinkPattern("((?!finger).)*", "links").matches(std::string(1000, 'x'))) << "usual ones are not";
  EXPECT_TRUE(LinkPattern("(?!.*finger).*", "links").matches(std::string(1000, 'x')));
}

TEST(LinkPattern, ManyNames) {
  std::string names;
  for (int i = 0; i < 100'000; ++i) names += (i ? "|" : "") + std::string("my_robot_link_") + std::to_string(i);
  const LinkPattern pattern(names, "links");
  EXPECT_TRUE(pattern.matches("my_robot_link_99999"));
  EXPECT_FALSE(pattern.matches("my_robot_link_100000"));
  ASSERT_TRUE(pattern.names());
  EXPECT_EQ(pattern.names()->size(), 100'000u);
}

TEST(LinkPattern, ListsOfNamesMeanWhatTheExpressionDoes) {
  EXPECT_EQ(*LinkPattern("left_arm|tool\\.0|a-b/c d||tool\\.0", "links").names(),
            (std::set<std::string>{"", "a-b/c d", "left_arm", "tool.0"}));
  EXPECT_EQ(*LinkPattern("", "links").names(), std::set<std::string>{""});
  for (const char* expression : {"a.", "a*", "a|(b)", "^a", "a$", "[a]", "a{2}", "a+", "a?", "\\d", "\\ba"})
    EXPECT_FALSE(LinkPattern(expression, "links").names()) << expression;
}

TEST(LinkPattern, RefusesWhatIsNoExpression) {
  for (const char* expression : {"(", "a{2", "[z-a]", "*", "(a)\\1", "a\\"}) {
    try {
      const LinkPattern pattern(expression, "links");
      ADD_FAILURE() << expression;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      EXPECT_EQ(std::string(error.what()).find("links '" + std::string(expression) + "' is invalid"), 0u) << error.what();
    }
  }
}

TEST(LinkPattern, SaysWhatIsWrongInItsOwnWords) {
  try {
    const LinkPattern pattern("arm_[", "--links");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "--links 'arm_[' is invalid: a '[' is not closed; add ']', or write \\[ for the character itself");
  }
}

// A configuration could not hold them.
TEST(LinkPattern, RefusesControlCharacters) {
  for (const std::string& expression : {std::string("a\nb"), std::string("a|b\t"), std::string("(a|\x1b).*"), std::string("a\0b", 3)})
    EXPECT_THROW(LinkPattern(expression, "links"), Error);
  EXPECT_TRUE(LinkPattern("a\\nb", "links").matches("a\nb")) << "as ECMAScript writes it";
}

// Memory and time would grow with the number of states, for each character of a name.
TEST(LinkPattern, RefusesWhatIsTooLong) {
  std::string groups;
  for (int i = 0; i < 300; ++i) groups += "(x*)";
  const std::string nested = std::string(101, '(') + "a" + std::string(101, ')');
  for (const std::string& expression : {groups, std::string(1000, 'a') + ".", std::string("(a?){99999}"), std::string("((a{20}){20}){20}"),
                                        std::string("a{7,99999999999999999999}")}) {
    try {
      const LinkPattern pattern(expression, "links");
      ADD_FAILURE() << expression;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      for (const std::string& part : {"of " + std::to_string(expression.size()) + " characters",
                                      "begins '" + expression.substr(0, 40) + "'", std::string("may have 1000; divide it")})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(LinkPattern(nested, "links"), Error) << "its compiler would overflow the stack";
  EXPECT_TRUE(LinkPattern(groups.substr(0, 1000), "links").matches(std::string(1000, 'x')));
  EXPECT_TRUE(LinkPattern("link_[0-9]{1,3}_[0-9]{1,3}", "links").matches("link_12_345"));
}

}  // namespace
}  // namespace collision_hulls
