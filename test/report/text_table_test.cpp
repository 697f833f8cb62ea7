// Tables for a terminal.
#include "report/text_table.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(TextTable, FiguresHaveThreeDigitsAndNoExponent) {
  EXPECT_EQ(figure(0.00123456), "0.0012");
  EXPECT_EQ(figure(1.23456), "1.23");
  EXPECT_EQ(figure(123456), "123456");
  EXPECT_EQ(figure(1e-9), "0");
  EXPECT_EQ(figureInMillimetres(0.0125), "12.5");
}

TEST(TextTable, TextIsAlignedLeftAndNumbersRight) {
  EXPECT_EQ(aligned({{"link", "mm", "status"}, {"ärmel", "12.5", "ok"}}, 1), "link     mm  status\närmel  12.5  ok\n");
}

}  // namespace
}  // namespace collision_hulls
