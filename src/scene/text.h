// Lengths in sentences.
#pragma once

#include <cstdio>
#include <string>

namespace collision_hulls {

/// "12.5 mm", "0.31 m"
inline std::string lengthText(double metres) {
  char text[64];
  std::snprintf(text, sizeof text, metres < 0.1 ? "%.3g mm" : "%.3g m", metres < 0.1 ? 1000 * metres : metres);
  return text;
}

}  // namespace collision_hulls
