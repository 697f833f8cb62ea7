// Lengths as text, for messages.
#pragma once

#include <cmath>
#include <string>

#include "base/decimal.h"

namespace collision_hulls {

/// "12.5 mm", "0.31 m"
inline std::string lengthText(double metres) {
  return metres < 0.1 ? decimal(1000 * metres, 3) + " mm" : decimal(metres, 3) + " m";
}

/// The same for a proved lower bound: rounded down.
inline std::string leastLengthText(double metres) {
  if (!(metres > 0)) return lengthText(0);
  const double unit = std::pow(10, std::floor(std::log10(metres)) - 2);
  return lengthText(std::floor(metres / unit) * unit);
}

}  // namespace collision_hulls
