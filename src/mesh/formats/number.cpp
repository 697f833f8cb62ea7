// Strict numbers. std::from_chars would do, but GCC 10 (Debian 11) lacks it for double; strtod follows the process's locale and takes
// hexadecimal numbers. So the characters are checked here, and most numbers computed: with up to 15 digits and a power of ten up to 22,
// both factors are exact doubles, and so their product is rounded once, correctly (Clinger, 1990). strtod_l does the rest, likewise
// correctly.
#include "mesh/formats/number.h"

#include <locale.h>
#include <strings.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace collision_hulls {
namespace {

constexpr int kExactDigits = 15;
// Powers of ten where counting ends, so far apart that the sum of both stays far from kPowersOfTen.
constexpr int kLargestExponent = 100'000, kFarBelow = 10 * kLargestExponent;
constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Drops a sign off the front; whether it was a minus.
bool takeSign(std::string_view* rest) {
  const bool negative = rest->substr(0, 1) == "-";
  if (negative || rest->substr(0, 1) == "+") rest->remove_prefix(1);
  return negative;
}

/// An unsigned number: digits * 10^power, if `digits` could hold all of them.
struct Decimal {
  std::uint64_t digits = 0;
  int significant = 0;  // how many of the digits count: none before the first that is not 0
  int power = 0;

  /// Takes digits off the front of `rest`, and moves the point left past each by `shift`; how many there were.
  std::size_t takeDigits(std::string_view* rest, int shift) {
    std::size_t count = 0;
    for (; count < rest->size() && isDigit((*rest)[count]); ++count) {
      if (significant == 0 && (*rest)[count] == '0') {
        if (power > -kFarBelow) power -= shift;
        continue;
      }
      if (++significant > kExactDigits) significant = kExactDigits + 1;
      if (significant <= kExactDigits) {
        digits = 10 * digits + static_cast<std::uint64_t>((*rest)[count] - '0');
        power -= shift;
      }
    }
    rest->remove_prefix(count);
    return count;
  }

  /// Takes an exponent's digits off the front of `rest`; false if there are none.
  bool takeExponent(std::string_view* rest) {
    const bool negative = takeSign(rest);
    int exponent = 0;
    std::size_t count = 0;
    for (; count < rest->size() && isDigit((*rest)[count]); ++count)
      if (exponent < kLargestExponent / 10) exponent = 10 * exponent + ((*rest)[count] - '0');
    rest->remove_prefix(count);
    power += negative ? -exponent : exponent;
    return count > 0;
  }

  /// Whether value() is the nearest double.
  bool isExact() const { return significant <= kExactDigits && std::abs(power) < static_cast<int>(kPowersOfTen.size()); }
  double value() const {
    const double factor = kPowersOfTen[static_cast<std::size_t>(std::abs(power))];
    return power < 0 ? static_cast<double>(digits) / factor : static_cast<double>(digits) * factor;
  }
};

bool equals(std::string_view word, std::string_view lower_case) {
  return word.size() == lower_case.size() && strncasecmp(word.data(), lower_case.data(), word.size()) == 0;
}

/// The unsigned "nan", "inf" or "infinity"; false if `word` is none.
bool parseNonFinite(std::string_view word, double* value) {
  if (word.size() < 3 || isDigit(word[0])) return false;
  if (equals(word, "nan")) {
    *value = std::numeric_limits<double>::quiet_NaN();
  } else if (equals(word, "inf") || equals(word, "infinity")) {
    *value = std::numeric_limits<double>::infinity();
  } else {
    return false;
  }
  return true;
}

/// Of an unsigned number whose characters have been checked.
double nearestDouble(std::string_view word) {
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return strtod_l(std::string(word).c_str(), nullptr, c_locale);
}

}  // namespace

bool parseNumber(std::string_view word, double* value) {
  const bool negative = takeSign(&word);
  if (!parseNonFinite(word, value)) {
    std::string_view rest = word;
    Decimal decimal;
    std::size_t count = decimal.takeDigits(&rest, 0);
    if (rest.substr(0, 1) == ".") {
      rest.remove_prefix(1);
      count += decimal.takeDigits(&rest, 1);
    }
    if (count == 0) return false;
    if (rest.substr(0, 1) == "e" || rest.substr(0, 1) == "E") {
      rest.remove_prefix(1);
      if (!decimal.takeExponent(&rest)) return false;
    }
    if (!rest.empty()) return false;
    *value = decimal.isExact() ? decimal.value() : nearestDouble(word);
  }
  if (negative) *value = -*value;
  return true;
}

bool parseInteger(std::string_view word, std::int64_t* value) {
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), *value);
  return failure == std::errc() && end == word.data() + word.size();
}

float toSingle(double value) {
  // The conversion itself is not defined beyond the range of float.
  if (std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max()) {
    // Up to half a unit above the largest float still rounds to it.
    constexpr double kHalfUnit = 0x1p103;
    const float rounded = std::abs(value) < static_cast<double>(std::numeric_limits<float>::max()) + kHalfUnit
                              ? std::numeric_limits<float>::max()
                              : std::numeric_limits<float>::infinity();
    return value < 0 ? -rounded : rounded;
  }
  return static_cast<float>(value);
}

}  // namespace collision_hulls
