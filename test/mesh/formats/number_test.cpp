#include "mesh/formats/number.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>

namespace collision_hulls {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double parsed(std::string_view word) {
  double value = -12345;
  EXPECT_TRUE(parseNumber(word, &value)) << word;
  return value;
}

TEST(ParseNumber, TakesWhatFromCharsTakes) {
  struct Case {
    const char* word;
    double value;
  };
  for (const Case& c : {Case{"0", 0},
                        {"-0", 0},
                        {"1", 1},
                        {"+1", 1},
                        {"-1", -1},
                        {"0001", 1},
                        {"1.", 1},
                        {".5", .5},
                        {"-.5", -.5},
                        {"1.e0", 1},
                        {"1E0", 1},
                        {"1e+00", 1},
                        {"5e-1", .5},
                        {"1e0005", 1e5},
                        {"10000000000000000000000e-22", 1},
                        {"0.00000000000000000000000001e26", 1},
                        {"1.00000000000000000000000000001", 1},
                        {"1e22", 1e22},
                        {"1e23", 1e23},
                        {"123456789.123456789", 123456789.123456789},
                        {"0.1234567890123456789012345", 0.1234567890123456789},
                        {"18446744073709551617", 18446744073709551617.},
                        {"99999999999999999999", 1e20},
                        {"4.9e-324", 4.9e-324}})
    EXPECT_EQ(parsed(c.word), c.value) << c.word;
}

TEST(ParseNumber, BeyondItsRangeIsInfinityOrZero) {
  for (const char* word : {"1e5000", "2e4294967297", "1e309", "inf", "INF", "Infinity", "+inf"}) EXPECT_EQ(parsed(word), kInfinity) << word;
  for (const char* word : {"-1e5000", "-inf"}) EXPECT_EQ(parsed(word), -kInfinity) << word;
  for (const char* word : {"1e-5000", "2e-4294967295", "0e99999999999999999999"}) EXPECT_EQ(parsed(word), 0) << word;
  EXPECT_EQ(parsed("0." + std::string(2000, '0') + "1e2001"), 1);
  EXPECT_EQ(parsed(std::string(2000, '9') + "e-2000"), 1);
  for (const int zeros : {990, 1010, 20'000}) {
    EXPECT_EQ(parsed("0." + std::string(static_cast<std::size_t>(zeros), '0') + "1e" + std::to_string(zeros)), 0.1) << zeros;
    EXPECT_EQ(parsed("0." + std::string(static_cast<std::size_t>(zeros), '0') + "1e" + std::to_string(zeros - 10)), 1e-11) << zeros;
  }
  for (const char* word : {"nan", "NaN", "-nan"}) EXPECT_TRUE(std::isnan(parsed(word))) << word;
}

TEST(ParseNumber, RefusesWhatOthersGuess) {
  for (const char* word : {"",       "-",       "--",        "+",      "+-1",   ".",   "-.",    "e5",  ".e5", "1e",  "1e+",
                           "1e-",    "1.5.2",   "1,5",       "1.0f",   "1_000", "0x1", "0x1p0", "1d1", "1-2", "1+1", "1.5e1.5",
                           "1.#INF", "1.#QNAN", "-nan(ind)", "nan(1)", "infin", "1 ",  " 1",    "1\v", "1/2", "٣",   "1%"}) {
    double value = 0;
    EXPECT_FALSE(parseNumber(word, &value)) << word;
  }
}

TEST(ParseNumber, IsTheNearestDoubleWhateverTheSpelling) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200'000; ++i) {
    char word[64];
    const double value = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 164);
    std::snprintf(word, sizeof word, random() % 2 != 0 ? "%.*e" : "%.*g", static_cast<int>(random() % 20), value);
    ASSERT_EQ(parsed(word), std::strtod(word, nullptr)) << word;
  }
}

TEST(ParseNumber, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  EXPECT_EQ(parsed("1.5"), 1.5);
  EXPECT_EQ(parsed("1.50000000000000000000001"), 1.5) << "takes the slow way";
  double value = 0;
  EXPECT_FALSE(parseNumber("1,5", &value));
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ParseInteger, RefusesWhatOthersGuess) {
  std::int64_t value = 0;
  EXPECT_TRUE(parseInteger("-42", &value));
  EXPECT_EQ(value, -42);
  EXPECT_TRUE(parseInteger("4294967298", &value));
  EXPECT_EQ(value, 4294967298);
  EXPECT_TRUE(parseInteger("0010", &value));
  EXPECT_EQ(value, 10) << "decimal";
  for (const char* word : {"", "-", "+1", "- 1", "1.0", "1e3", "0x1", "1/", "99999999999999999999"})
    EXPECT_FALSE(parseInteger(word, &value)) << word;
}

TEST(ToSingle, RoundsToTheNearest) {
  constexpr float kMost = std::numeric_limits<float>::max();
  EXPECT_EQ(toSingle(0.1), 0.1f);
  EXPECT_EQ(toSingle(3.4028235e38), kMost);
  EXPECT_EQ(toSingle(-3.40282356e38), -kMost);
  EXPECT_EQ(toSingle(3.4028236e38), std::numeric_limits<float>::infinity());
  EXPECT_EQ(toSingle(-1e300), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(toSingle(1e-45), std::numeric_limits<float>::denorm_min());
  EXPECT_TRUE(std::isnan(toSingle(std::nan(""))));
}

}  // namespace
}  // namespace collision_hulls
