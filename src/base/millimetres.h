// Lengths for messages.
#pragma once

#include <cstdio>
#include <string>

namespace collision_hulls {

/// "12.5 mm" for 0.0125 m.
inline std::string millimetres(double metres, int digits = 4) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g mm", digits, 1000 * metres);
  return text;
}

/// The same for a length that is more than `limit`, with enough digits to show it: "10.0004 mm" beside "10 mm".
inline std::string millimetresBeyond(double metres, double limit) {
  int digits = 4;
  while (digits < 17 && millimetres(metres, digits) == millimetres(limit)) ++digits;
  return millimetres(metres, digits);
}

}  // namespace collision_hulls
