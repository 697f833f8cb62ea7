#include "base/finite_number.h"

#include <gtest/gtest.h>

#include "comma_locale.h"

namespace collision_hulls {
namespace {

TEST(ParseFinite, TheWholeWordOrNothing) {
  double value = 0;
  EXPECT_TRUE(parseFinite("-1.5e-3", value));
  EXPECT_EQ(value, -0.0015);
  for (const char* word : {"", "1,5", "1.5m", "nan", "inf", "1e999"}) EXPECT_FALSE(parseFinite(word, value)) << word;
}

TEST(ParseFinite, WhateverTheLocale) {
  const CommaLocale german;
  double value = 0;
  EXPECT_TRUE(parseFinite("1.5", value));
  EXPECT_EQ(value, 1.5);
  EXPECT_FALSE(parseFinite("1,5", value));
}

}  // namespace
}  // namespace collision_hulls
