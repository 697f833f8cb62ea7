// Lengths for messages.
#pragma once

#include <string>

#include "base/decimal.h"

namespace collision_hulls {

/// "12.5 mm" for 0.0125 m.
inline std::string millimetres(double metres, int digits = 4) {
  return decimal(1000 * metres, digits) + " mm";
}

/// The same for a length that is more than `limit`, with enough digits to show it: "10.0004 mm" beside "10 mm".
inline std::string millimetresBeyond(double metres, double limit) {
  int digits = 4;
  while (digits < 17 && millimetres(metres, digits) == millimetres(limit)) ++digits;
  return millimetres(metres, digits);
}

}  // namespace collision_hulls
