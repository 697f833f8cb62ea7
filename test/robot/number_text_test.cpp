#include "robot/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <random>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

TEST(NumberText, IsShort) {
  EXPECT_EQ(numberText(0), "0");
  EXPECT_EQ(numberText(-0.0), "0");
  EXPECT_EQ(numberText(1), "1");
  EXPECT_EQ(numberText(-0.1), "-0.1");
  EXPECT_EQ(numberText(1.5707963267949), "1.5707963267949");
  EXPECT_EQ(numberText(1200), "1200");
}

TEST(NumberText, RefusesWhatIsNotFinite) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) EXPECT_THROW(numberText(value), Error);
}

TEST(NumberText, HasNoExponent) {
  EXPECT_EQ(numberText(1e-7), "0.0000001");
  EXPECT_EQ(numberText(-2.5e-12), "-0.0000000000025");
  EXPECT_EQ(numberText(1e15), "1000000000000000");
}

TEST(NumberText, ReadsBackExactly) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::strtod(numberText(value).c_str(), nullptr), value) << "bits " << bits;
  }
  for (const double value : {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 1.0 / 3, M_PI}) {
    EXPECT_EQ(std::strtod(numberText(value).c_str(), nullptr), value);
  }
}

struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(NumberText, DoesNotDependOnTheLocale) {
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  EXPECT_EQ(numberText(1234567.25), "1234567.25");
  std::locale::global(old);
}

}  // namespace
}  // namespace collision_hulls
