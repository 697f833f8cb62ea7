// Looks, and the control that they look at.
#include "base/looks.h"

#include <gtest/gtest.h>

#include "counted_looks.h"

namespace collision_hulls {
namespace {

TEST(Looks, OneForSoManyItems) {
  const CountedLooks looks;
  Looks look(looks.control(), 10);
  for (int i = 0; i < 9; ++i) look();
  EXPECT_EQ(looks.count(), 0u);
  look();
  EXPECT_EQ(looks.count(), 1u);
  for (int i = 0; i < 95; ++i) look();
  EXPECT_EQ(looks.count(), 10u);
}

TEST(Looks, ThrowsWhatTheCheckThrows) {
  const RunControl control;
  control.cancel();
  Looks look(control, 2);
  EXPECT_NO_THROW(look());
  EXPECT_THROW(look(), Error);
}

TEST(RunControl, EndsWhenAskedTo) {
  bool end = false;
  RunControl whole, part;
  whole.ends = [&] { return end; };
  part.whole = &whole;
  EXPECT_FALSE(part.cancelled());
  EXPECT_NO_THROW(part.check());
  end = true;
  EXPECT_TRUE(part.cancelled());
  try {
    part.check();
    FAIL() << "it goes on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

}  // namespace
}  // namespace collision_hulls
