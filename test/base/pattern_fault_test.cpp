#include "base/pattern_fault.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

std::string faultOf(const std::string& expression) {
  try {
    const std::regex compiled(expression);
  } catch (const std::regex_error& error) {
    return patternFault(error.code());
  }
  return "";
}

TEST(PatternFault, NamesTheCharacterAndTheRemedy) {
  EXPECT_EQ(faultOf("arm_[0-9]"), "");
  EXPECT_EQ(faultOf("arm_["), "a '[' is not closed; add ']', or write \\[ for the character itself");
  EXPECT_EQ(faultOf("a{2"), "a '{' is not closed; add '}', or write \\{ for the character itself");
  for (const char* expression : {"(arm", "arm)", "a|*"}) EXPECT_EQ(faultOf(expression).rfind("a '(' or ')' lacks", 0), 0u) << expression;
  for (const char* expression : {"a{x}", "a{2,1}"}) EXPECT_EQ(faultOf(expression).rfind("a '{' has no valid number", 0), 0u) << expression;
  EXPECT_EQ(faultOf("[z-a]").rfind("a '-' within [...] has no range", 0), 0u);
  EXPECT_EQ(faultOf("[[:arm:]]").rfind("a class within [...] is unknown", 0), 0u);
  EXPECT_EQ(faultOf("arm\\").rfind("a '\\' escapes nothing", 0), 0u);
  EXPECT_EQ(patternFault(std::regex_constants::error_backref).rfind("\\1 and its like, back-references", 0), 0u);
  EXPECT_EQ(patternFault(std::regex_constants::error_space).rfind("it is too long", 0), 0u);
}

}  // namespace
}  // namespace collision_hulls
