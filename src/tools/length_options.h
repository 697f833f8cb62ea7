// Lengths on a command line. What is too long is refused as it was given: 5 for 5 mm is the usual mistake.
#pragma once

#include <string>

#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "collision_hulls/report/options.h"
#include "report/largest_tolerance.h"

namespace collision_hulls {

/// Throws kBadOption for a length [m] above the largest. `text`: what gave it; `otherwise`: a sentence on what else helps.
inline void expectUnitIn(const std::string& text, double metres, const std::string& option, const std::string& otherwise = "") {
  if (metres <= kLargestTolerance || metres == Length::kUnset) return;
  const bool has_unit = text.find_first_of("mi") != std::string::npos;  // of each unit
  const bool is_metres = text.find_first_of("ci") == std::string::npos && text.find("mm") == std::string::npos;
  const double thousandth = metres / 1000;
  throw Error(ErrorCode::kBadOption,
              option + " '" + text + "' is more than " + decimal(kLargestTolerance) + " m, the largest that makes sense for a mesh" +
                  (has_unit ? "" : ": a number without a unit is in metres") +
                  (is_metres && thousandth <= kLargestTolerance ? "; did you mean " + toString(lengthOf(thousandth)) + "?"
                                                                : "; give a smaller length, as in 5mm.") +
                  otherwise);
}

/// parseLength(), up to the largest.
inline Length lengthIn(const std::string& text, const std::string& option) {
  const Length length = parseLength(text, option);
  expectUnitIn(text, length.limit, option, " For a larger machine give a percentage, such as 5%");
  return length;
}

/// parseMetresOrZero(), likewise.
inline double metresOrZeroIn(const std::string& text, const std::string& option) {
  const double metres = parseMetresOrZero(text, option);
  expectUnitIn(text, metres, option);
  return metres;
}

}  // namespace collision_hulls
