#include "base/in_context.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(InContext, KeepsTheCode) {
  try {
    inContext("body 'a'", [] { throw Error(ErrorCode::kBadScale, "zero"); });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadScale);
    EXPECT_STREQ(error.what(), "body 'a': zero");
  }
}

}  // namespace
}  // namespace collision_hulls
