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

}  // namespace
}  // namespace collision_hulls
