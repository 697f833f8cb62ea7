// Numbers as people read them: in tables, on pages.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "base/decimal.h"

namespace collision_hulls {

/// Three significant digits, fewer below 0.01, and never an exponent: 0.0012, 1.23, 123, 12345.
inline std::string figure(double value) {
  constexpr int kMostDecimals = 4;
  constexpr double kLeast = 0.00005;  // what they can show
  if (std::abs(value) < kLeast) return "0";
  const double magnitude = std::floor(std::log10(std::abs(value)));
  const int decimals = std::isfinite(magnitude) ? std::clamp(2 - static_cast<int>(magnitude), 0, kMostDecimals) : 0;
  return fixedDecimal(value, decimals);
}

}  // namespace collision_hulls
