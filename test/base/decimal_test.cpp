#include "base/decimal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>

#include "base/figure.h"
#include "base/millimetres.h"
#include "comma_locale.h"

namespace collision_hulls {
namespace {

std::string printed(const char* format, int digits, double value) {
  char text[400];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

void expectAsPrinted(double value) {
  for (int digits = 0; digits <= 17; ++digits) {
    EXPECT_EQ(decimal(value, digits), printed("%.*g", digits, value));
    EXPECT_EQ(fixedDecimal(value, digits), printed("%.*f", digits, value));
  }
  EXPECT_EQ(fixedDecimal(value), std::to_string(value));
}

TEST(Decimal, IsWhatPrintfWrites) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, 1.0, 0.1, -2.5, 1e5, 1e6, 123456.5, 1e-4, 1e-5, 1e21, Limits::max(), Limits::min(),
                             Limits::denorm_min(), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    expectAsPrinted(value);
}

TEST(Decimal, IsWhatPrintfWritesOfRandomNumbers) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    expectAsPrinted(value);
  }
}

TEST(Decimal, HasAPointWhateverTheLocale) {
  const CommaLocale locale;
  EXPECT_EQ(decimal(1234567.25, 9), "1234567.25");
  EXPECT_EQ(fixedDecimal(0.012), "0.012000");
  std::ostringstream stream = decimalStream(4);
  stream << 1.23456 << ' ' << 1234567;
  EXPECT_EQ(stream.str(), "1.235 1234567");
  EXPECT_EQ(figure(1.234), "1.23");
  EXPECT_EQ(millimetres(0.0125), "12.5 mm");
  if (!CommaLocale::isOfC()) GTEST_SKIP() << "there is no locale with a comma, so printf has none either";
  EXPECT_EQ(printed("%.*g", 4, 1.5), "1,5");
}

}  // namespace
}  // namespace collision_hulls
