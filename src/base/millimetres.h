// Lengths for messages.
#pragma once

#include <cstdio>
#include <string>

namespace collision_hulls {

/// "12.5 mm" for 0.0125 m.
inline std::string millimetres(double metres) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g mm", 1000 * metres);
  return text;
}

}  // namespace collision_hulls
