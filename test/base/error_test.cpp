#include "collision_hulls/error.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace collision_hulls {
namespace {

TEST(Error, EachCodeHasANameOfItsOwn) {
  std::set<std::string> names;
  const int count = static_cast<int>(ErrorCode::kInternal) + 1;  // the last one
  for (int code = 0; code < count; ++code) names.insert(name(static_cast<ErrorCode>(code)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(count));
  EXPECT_EQ(names.count("Unknown"), 0u);
}

TEST(Error, KeepsItsCodeAndText) {
  const Error error(ErrorCode::kBadScale, "scale 0 0 0");
  EXPECT_EQ(error.code(), ErrorCode::kBadScale);
  EXPECT_STREQ(error.what(), "scale 0 0 0");
  EXPECT_STREQ(name(error.code()), "BadScale");
}

TEST(Error, HoldsNothingThatATerminalObeys) {
  EXPECT_STREQ(Error(ErrorCode::kBadScene, "body '\x1b]0;x\x07.\r.\x7f' is odd;\n\tremove it, \u00fc").what(),
               "body '?]0;x?.?.?' is odd;\n\tremove it, \u00fc");
}

TEST(Error, NeverRepeatsAWholeFile) {
  const std::string usual(4000, 'a');
  EXPECT_EQ(Error(ErrorCode::kBadScale, usual).what(), usual);
  const std::string text = Error(ErrorCode::kBadScale, "'" + std::string(1000000, 'a') + "' is odd; correct it").what();
  EXPECT_LT(text.size(), 4100u);
  EXPECT_EQ(text.substr(0, 3), "'aa");
  EXPECT_NE(text.find("(1000021 bytes)"), std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 12), "; correct it");
}

}  // namespace
}  // namespace collision_hulls
