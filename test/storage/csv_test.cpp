#include "storage/csv.h"

#include <gtest/gtest.h>

#include "comma_locale.h"

namespace collision_hulls {
namespace {

TEST(Csv, QuotesFieldsThatNeedIt) {
  EXPECT_EQ(csvLine({}), "\n");
  EXPECT_EQ(csvLine({"a", "", "b c"}), "a,,b c\n");
  EXPECT_EQ(csvLine({"a,b", "say \"x\"", "two\nlines", "cr\r"}), "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\",\"cr\r\"\n");
}

TEST(Csv, WhatASpreadsheetWouldComputeBecomesText) {
  EXPECT_EQ(csvLine({"=1+1", "+a", "-a", "@a", "\ta"}), "'=1+1,'+a,'-a,'@a,'\ta\n");
  EXPECT_EQ(csvLine({"=A1,B1"}), "\"'=A1,B1\"\n");
  EXPECT_EQ(csvLine({"-0.5", "-1e-09", "-inf", "a=b", "'"}), "-0.5,-1e-09,-inf,a=b,'\n");
}

TEST(Csv, Numbers) {
  EXPECT_EQ(csvNumber({}), "");
  EXPECT_EQ(csvNumber(0), "0");
  EXPECT_EQ(csvNumber(0.1), "0.1");
  EXPECT_EQ(csvNumber(1.0 / 3), "0.333333333");
  EXPECT_EQ(csvNumber(1e-12), "1e-12");
}

TEST(Csv, NumbersHaveAPointWhateverTheLocale) {
  const CommaLocale locale;
  EXPECT_EQ(csvLine({csvNumber(1234.5), csvCount(1234567)}), "1234.5,1234567\n");
}

}  // namespace
}  // namespace collision_hulls
