// Lengths on a command line. What is too long is refused as it was given: 5 for 5 mm is the usual mistake.
#pragma once

#include <string>

#include "collision_hulls/report/options.h"
#include "report/largest_tolerance.h"

namespace collision_hulls {

/// Whether a length was given with a unit.
inline bool hasUnit(const std::string& text) {
  return text.find_first_of("mi") != std::string::npos;  // of each
}

/// parseLength(), up to the largest.
inline Length lengthIn(const std::string& text, const std::string& option) {
  const Length length = parseLength(text, option);
  expectUnit(option, text, length.limit, hasUnit(text), " For a larger machine give a percentage, such as 5%");
  return length;
}

/// parseMetresOrZero(), likewise.
inline double metresOrZeroIn(const std::string& text, const std::string& option) {
  const double metres = parseMetresOrZero(text, option);
  expectUnit(option, text, metres, hasUnit(text));
  return metres;
}

}  // namespace collision_hulls
